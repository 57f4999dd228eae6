#include "ui/dialogs/mesh_dialog.h"

#include <algorithm>
#include <cmath>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "scene/rules/needs.h"
#include "ui/language/number_text.h"
#include "volume/extraction/surface_mesh.h"

namespace isolux::ui {

namespace {
constexpr int meshPollMilliseconds = 50;
}

MeshDialog::MeshDialog(std::shared_ptr<const volume::PreparedVolume> volume, scene::Scene resolved,
                       QWidget* parent)
    : QDialog(parent),
      surface(new QComboBox(this)),
      tolerance(new QDoubleSpinBox(this)),
      closed(new QCheckBox(tr("&Cap openings at the volume border"), this)),
      start(new QPushButton(tr("&Export…"), this)),
      showPlace(new QPushButton(tr("Sho&w largest deviation"), this)),
      bar(new QProgressBar(this)),
      volume_(std::move(volume)),
      resolved_(std::move(resolved)),
      estimate_(new QLabel(this)),
      text_(new QLabel(this)) {
  setWindowTitle(tr("Export mesh"));
  tolerance->setRange(0.0, 1000.0);
  tolerance->setDecimals(3);
  tolerance->setSingleStep(0.01);
  tolerance->setSuffix(" mm");
  tolerance->setSpecialValueText(tr("No subdivision"));
  tolerance->setAccessibleName(tr("Tolerance"));
  tolerance->setToolTip(tr("Largest deviation from the surface: triangles are split until they meet it"));
  bar->setRange(0, 1000);
  bar->setTextVisible(false);
  bar->setFixedHeight(8);
  bar->setAccessibleName(tr("Progress"));
  text_->setWordWrap(true);
  text_->setMinimumWidth(380);
  start->setDefault(true);

  auto* form = new QFormLayout;
  const QString unit = QString::fromStdString(volume_->volume.unit);
  surface->setAccessibleName(tr("Isovalue"));
  surface->addItem(valueText(resolved_.isosurface.value.value_or(0.0), unit),
                   resolved_.isosurface.value.value_or(0.0));
  for (const scene::ExtraIsosurface& extra : resolved_.extraIsosurfaces)
    if (extra.shown) surface->addItem(valueText(extra.value.value_or(0.0), unit), extra.value.value_or(0.0));
  form->addRow(tr("Isovalue"), surface);
  form->addRow(tr("Tolerance"), tolerance);
  form->addRow(QString(), closed);
  form->addRow(tr("Triangles"), estimate_);
  auto* buttons = new QHBoxLayout;
  auto* close = new QPushButton(tr("Close"), this);
  buttons->addWidget(showPlace);
  buttons->addStretch(1);
  buttons->addWidget(close);
  buttons->addWidget(start);
  showPlace->hide();
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addWidget(text_);
  layout->addWidget(bar);
  layout->addLayout(buttons);

  const bool cut = resolved_.isosurface.clipped && scene::cutsSurfaces(resolved_);
  resolved_.isosurface.clipped = false;
  const QString what =
      tr("Exports the surface as shown, without hidden pieces. The extension sets the format: .stl, .ply, "
         ".obj or .vtp. A .vtp file also contains curvature and the values of a second volume.");
  tell(cut ? tr("%1 Cuts are ignored: the whole surface is exported.").arg(what) : what);
  timer_.setInterval(meshPollMilliseconds);
  connect(&timer_, &QTimer::timeout, this, &MeshDialog::poll);
  connect(start, &QPushButton::clicked, this, &MeshDialog::startOrStop);
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  connect(showPlace, &QPushButton::clicked, this, [this] { Q_EMIT placeAsked(job_->made().farthest); });
  connect(surface, &QComboBox::currentIndexChanged, this, &MeshDialog::showEstimate);
  connect(tolerance, &QDoubleSpinBox::valueChanged, this, &MeshDialog::showEstimate);
  showEstimate();
}

scene::Scene MeshDialog::chosenScene() const {
  scene::Scene scene = resolved_;
  scene.isosurface.value = surface->currentData().toDouble();
  return scene;
}

void MeshDialog::showEstimate() {
  const std::size_t count =
      volume::estimatedTriangles(volume_->grid(), *volume_->blocks, surface->currentData().toDouble());
  const QString about = tr("about %1").arg(valueText(static_cast<double>(count), {}, 2));
  const bool split = tolerance->value() > 0.0;
  estimate_->setText(count == 0 ? tr("unknown until export")
                     : split    ? tr("%1 or more, depending on the tolerance").arg(about)
                                : about);
}

MeshDialog::~MeshDialog() = default;

QString MeshDialog::text() const {
  return text_->text();
}

void MeshDialog::tell(const QString& text, Ink ink) {
  text_->setText(text);
  setInk(text_, ink);
}

void MeshDialog::startOrStop() {
  if (exporting()) {
    job_->progress().requestStop();
    return;
  }
  const QString file = ask_ ? ask_() : QString();
  if (!file.isEmpty()) exportTo(file);
}

void MeshDialog::exportTo(const QString& file) {
  if (exporting()) return;
  app::MeshWish wish{file.toStdString(), tolerance->value(), closed->isChecked()};
  job_ = std::make_unique<app::MeshJob>(volume_, chosenScene(), std::move(wish));
  showPlace->hide();
  start->setText(tr("Stop"));
  left_.begin();
  timer_.start();
  poll();
}

void MeshDialog::poll() {
  const QString file = QString::fromStdString(job_->wish().file.string());
  const QString name = QFileInfo(file).fileName();
  if (!job_->finished()) {
    const double fraction = std::clamp(job_->progress().fraction(), 0.0, 1.0);
    bar->setValue(static_cast<int>(std::lround(fraction * 1000.0)));
    const QString rest = left_.text(fraction);
    tell(rest.isEmpty() ? tr("Writing %1…").arg(name) : tr("Writing %1… %2").arg(name, rest));
    return;
  }
  timer_.stop();
  start->setText(tr("&Export…"));
  bar->setValue(0);
  if (const auto& error = job_->error()) {
    const bool stopped = error->kind() == base::ErrorKind::interrupted;
    tell(stopped ? tr("Stopped: nothing was written.") : QString::fromStdString(error->what()),
         stopped ? Ink::normal : Ink::error);
    return;
  }
  bar->setValue(1000);
  const QString made = QString::fromStdString(app::meshText(job_->made()));
  const QString warning = QString::fromStdString(app::meshWarning(job_->made()));
  tell(warning.isEmpty() ? tr("Saved %1: %2.").arg(name, made)
                         : tr("Saved %1: %2. %3.").arg(name, made, warning),
       warning.isEmpty() ? Ink::normal : Ink::warning);
  showPlace->setVisible(job_->made().beyond > 0);
  Q_EMIT exported(file, made);
}

}  // namespace isolux::ui
