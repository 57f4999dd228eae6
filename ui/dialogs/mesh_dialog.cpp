#include "ui/dialogs/mesh_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QProgressBar>
#include <QPushButton>

#include "scene/rules/needs.h"
#include "scene/shown_surfaces.h"
#include "ui/language/number_text.h"
#include "ui/widgets/parts.h"
#include "volume/extraction/surface_mesh.h"

namespace isolux::ui {

MeshDialog::MeshDialog(std::shared_ptr<const volume::PreparedVolume> volume, scene::Scene resolved,
                       QWidget* parent)
    : QDialog(parent),
      surface(new QComboBox(this)),
      tolerance(new QDoubleSpinBox(this)),
      closed(new QCheckBox(tr("&Cap openings at the volume border"), this)),
      start(new QPushButton(tr("&Export…"), this)),
      showPlace(new QPushButton(tr("Sho&w largest deviation"), this)),
      bar(thinBar(this)),
      volume_(std::move(volume)),
      resolved_(std::move(resolved)),
      estimate_(new QLabel(this)),
      text_(wrappedLabel({}, this)) {
  setWindowTitle(tr("Export mesh"));
  tolerance->setRange(0.0, 1000.0);
  tolerance->setDecimals(3);
  tolerance->setSingleStep(0.01);
  tolerance->setSuffix(" mm");
  tolerance->setSpecialValueText(tr("No subdivision"));
  nameAndTip(tolerance, tr("Tolerance"),
             tr("Largest deviation from the surface: triangles are split until they meet it"));
  bar->setAccessibleName(tr("Progress"));
  text_->setMinimumWidth(380);
  start->setDefault(true);

  auto* form = new QFormLayout;
  const QString unit = QString::fromStdString(volume_->volume.unit);
  surface->setAccessibleName(tr("Isovalue"));
  for (const auto& shown : scene::shownSurfaces(resolved_))
    surface->addItem(valueText(shown.value.value_or(0.0), unit), shown.value.value_or(0.0));
  form->addRow(tr("Isovalue"), surface);
  form->addRow(tr("Tolerance"), tolerance);
  form->addRow(QString(), closed);
  form->addRow(tr("Triangles"), estimate_);
  auto* close = new QPushButton(tr("Close"), this);
  showPlace->hide();
  layOut(this, columnOf({form, text_, bar, lineOf({showPlace, Cell::room(), close, start})}));

  const bool cut = resolved_.surfaces.front().clipped && scene::cutsSurfaces(resolved_);
  resolved_.surfaces.front().clipped = false;
  const QString what =
      tr("Exports the surface as shown, without hidden pieces. The extension sets the format: .stl, .ply, "
         ".obj or .vtp. A .vtp file also contains curvature and the values of a second volume.");
  tell(cut ? tr("%1 Cuts are ignored: the whole surface is exported.").arg(what) : what);
  connect(start, &QPushButton::clicked, this, &MeshDialog::startOrStop);
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  connect(showPlace, &QPushButton::clicked, this, [this] { Q_EMIT placeAsked(farthest_); });
  connect(surface, &QComboBox::currentIndexChanged, this, &MeshDialog::showEstimate);
  connect(tolerance, &QDoubleSpinBox::valueChanged, this, &MeshDialog::showEstimate);
  showEstimate();
}

scene::Scene MeshDialog::chosenScene() const {
  scene::Scene scene = resolved_;
  scene.surfaces.front().value = surface->currentData().toDouble();
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

void MeshDialog::tell(const QString& text, Ink ink) {
  text_->setText(text);
  setInk(text_, ink);
}

void MeshDialog::startOrStop() {
  if (exporting()) {
    task_->progress().requestStop();
    return;
  }
  const QString file = ask_ ? ask_() : QString();
  if (!file.isEmpty()) exportTo(file);
}

void MeshDialog::exportTo(const QString& file) {
  if (exporting()) return;
  const app::MeshRequest request{file.toStdString(), tolerance->value(), closed->isChecked()};
  const QString name = QFileInfo(file).fileName();
  const auto work = [volume = volume_, scene = chosenScene(), request](base::Progress& progress) {
    return app::exportMesh(request, scene, *volume, progress);
  };
  showPlace->hide();
  start->setText(tr("Stop"));
  left_.begin();
  task_.watch(
      base::Task<volume::SurfaceMesh>::start({request.file.string(), "make the mesh"}, work),
      [this, file](auto& task) { take(file, task); }, [this, name] { showProgress(name); });
  showProgress(name);
}

void MeshDialog::showProgress(const QString& name) {
  const double fraction = task_->progress().fraction();
  showFraction(bar, fraction);
  const QString rest = left_.text(fraction);
  tell(rest.isEmpty() ? tr("Writing %1…").arg(name) : tr("Writing %1… %2").arg(name, rest));
}

void MeshDialog::take(const QString& file, base::Task<volume::SurfaceMesh>& task) {
  start->setText(tr("&Export…"));
  showFraction(bar, 0.0);
  if (const auto& error = task.error()) {
    const bool stopped = error->kind() == base::ErrorKind::interrupted;
    tell(stopped ? tr("Stopped: nothing was written.") : QString::fromStdString(error->what()),
         stopped ? Ink::normal : Ink::error);
    return;
  }
  showFraction(bar, 1.0);
  const volume::SurfaceMesh& mesh = task.value();
  const QString name = QFileInfo(file).fileName();
  const QString made = QString::fromStdString(app::meshText(mesh));
  const QString warning = QString::fromStdString(app::meshWarning(mesh));
  tell(warning.isEmpty() ? tr("Saved %1: %2.").arg(name, made)
                         : tr("Saved %1: %2. %3.").arg(name, made, warning),
       warning.isEmpty() ? Ink::normal : Ink::warning);
  farthest_ = mesh.farthest;
  showPlace->setVisible(mesh.beyond > 0);
  Q_EMIT exported(file, made);
}

}  // namespace isolux::ui
