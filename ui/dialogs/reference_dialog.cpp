#include "ui/dialogs/reference_dialog.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/documents/picture_scene.h"
#include "app/documents/session.h"
#include "app/files/image_io.h"
#include "app/files/reference_image.h"
#include "ui/document/privacy.h"
#include "ui/language/number_text.h"
#include "ui/theme/style.h"
#include "ui/widgets/save_dialog.h"

namespace isolux::ui {

namespace {
constexpr int pollMilliseconds = 100, defaultSamples = 256;

QSpinBox* makeBox(int low, int high, int value, const QString& name, QWidget* parent) {
  auto* box = new QSpinBox(parent);
  box->setRange(low, high);
  box->setValue(value);
  box->setAccessibleName(name);
  return box;
}

void write(const gi::ReferenceImage& image, const scene::Scene& carried, const volume::Patient& patient,
           const std::filesystem::path& file) {
  const std::string session = app::pictureSessionText(carried, file.parent_path(), patient);
  const QString name = QString::fromStdString(file.filename().string());
  if (name.endsWith(".png", Qt::CaseInsensitive)) {
    app::writePng(app::screenImage(image, carried), file, session);
  } else if (name.endsWith(".exr", Qt::CaseInsensitive)) {
    app::writeReferenceExr(image, file, session);
  } else {
    base::throwInput(name.toStdString(), "",
                     QObject::tr("unknown image format; use .png or .exr").toStdString());
  }
}
}  // namespace

ReferenceDialog::ReferenceDialog(std::shared_ptr<const volume::PreparedVolume> volume,
                                 const scene::Scene& given, scene::Scene resolved, QSize size,
                                 std::optional<int> threads, QWidget* parent)
    : QDialog(parent),
      volume_(std::move(volume)),
      carried_(app::carriedScene(given, resolved)),
      resolved_(std::move(resolved)),
      threads_(threads),
      width_(makeBox(1, 16384, size.width(), tr("Width"), this)),
      height_(makeBox(1, 16384, size.height(), tr("Height"), this)),
      samples_(makeBox(1, 1000000, defaultSamples, tr("Paths per pixel"), this)),
      shown_(new QComboBox(this)),
      preview_(new QLabel(this)),
      text_(new QLabel(this)),
      bar_(new QProgressBar(this)),
      start_(new QPushButton(tr("Trace"), this)),
      save_(new QPushButton(tr("Save…"), this)) {
  setWindowTitle(tr("Path-traced image"));
  resize(820, 640);
  preview_->setAlignment(Qt::AlignCenter);
  preview_->setMinimumSize(320, 240);
  preview_->setBackgroundRole(QPalette::Base);
  preview_->setAutoFillBackground(true);
  preview_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
  text_->setWordWrap(true);
  bar_->setRange(0, 1000);
  bar_->setTextVisible(false);
  bar_->setFixedHeight(8);
  shown_->addItems({tr("Image"), tr("Noise (white: 10 % or more)")});
  shown_->setAccessibleName(tr("Display"));
  save_->setEnabled(false);
  start_->setDefault(true);

  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("Size"), this));
  row->addWidget(width_);
  row->addWidget(new QLabel("×", this));
  row->addWidget(height_);
  row->addSpacing(16);
  row->addWidget(new QLabel(tr("Paths per pixel"), this));
  row->addWidget(samples_);
  row->addStretch(1);
  row->addWidget(shown_);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(text_, 1);
  buttons->addWidget(start_);
  buttons->addWidget(save_);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(row);
  layout->addWidget(preview_, 1);
  layout->addWidget(bar_);
  layout->addLayout(buttons);
  tell(
      tr("Traces every pixel independently, without baked light. Twice as many paths take twice the time; "
         "four times as many halve the noise."));

  timer_.setInterval(pollMilliseconds);
  connect(&timer_, &QTimer::timeout, this, &ReferenceDialog::poll);
  saveTimer_.setInterval(pollMilliseconds);
  connect(&saveTimer_, &QTimer::timeout, this, &ReferenceDialog::pollSaving);
  connect(start_, &QPushButton::clicked, this, &ReferenceDialog::startOrStop);
  connect(save_, &QPushButton::clicked, this, &ReferenceDialog::choose);
  connect(shown_, &QComboBox::currentIndexChanged, this, &ReferenceDialog::showImage);
}

ReferenceDialog::~ReferenceDialog() = default;

void ReferenceDialog::tell(const QString& text, bool wrong) {
  text_->setText(text);
  setInk(text_, wrong ? Ink::error : Ink::quiet);
}

QString ReferenceDialog::text() const {
  return text_->text();
}

void ReferenceDialog::startOrStop() {
  if (tracing()) {
    job_->progress().requestStop();
    return;
  }
  round_.reset();
  job_ =
      std::make_unique<app::ReferenceJob>(volume_, resolved_, glm::ivec2(width_->value(), height_->value()),
                                          static_cast<std::uint32_t>(samples_->value()), threads_);
  start_->setText(tr("Stop"));
  left_.begin();
  timer_.start();
}

void ReferenceDialog::poll() {
  const bool finished = job_->finished();  // before the image is looked at: none comes after it
  if (const app::RoundPointer round = job_->round(); round != round_) {
    round_ = round;
    save_->setEnabled(!saving());
    showImage();
  }
  const double fraction = std::clamp(job_->progress().fraction(), 0.0, 1.0);
  bar_->setValue(static_cast<int>(std::lround(1000.0 * fraction)));
  QString noise;
  if (round_ && round_->noisePart) noise = tr("noise %1 %").arg(numberText(100.0 * *round_->noisePart, 2));
  if (!finished) {
    QStringList said{tr("Tracing…")};
    for (const QString& part : {noise, left_.text(fraction)})
      if (!part.isEmpty()) said += part;
    tell(said.join(" · "));
    return;
  }
  timer_.stop();
  start_->setText(tr("Trace"));
  if (job_->error()) {
    tell(QString::fromStdString(job_->error()->what()), true);
  } else {
    const QString end = job_->progress().stopRequested() ? tr("Stopped") : tr("Complete");
    tell(noise.isEmpty() ? end : end + ": " + noise);
  }
}

void ReferenceDialog::showImage() {
  if (!round_) return;
  const render::ColorImage& screen = shown_->currentIndex() == 0 ? round_->picture : round_->noise;
  const QImage image(screen.rgba.data(), screen.size.x, screen.size.y, qsizetype{4} * screen.size.x,
                     QImage::Format_RGBA8888);
  preview_->setPixmap(
      QPixmap::fromImage(image).scaled(preview_->size(), Qt::KeepAspectRatio, Qt::SmoothTransformation));
}

void ReferenceDialog::resizeEvent(QResizeEvent* event) {
  QDialog::resizeEvent(event);
  showImage();
}

void ReferenceDialog::choose() {
  const SaveAnswer answer = askForFileToSave(
      this,
      {tr("Save path-traced image"),
       QSettings().value("lastFolder").toString() + "/reference.exr",
       {tr("OpenEXR, linear colours, irradiance and variance (*.exr)"), tr("PNG, with session (*.png)")}});
  if (answer.file.isEmpty()) return;
  QSettings().setValue("lastFolder", QFileInfo(answer.file).absolutePath());
  saveAs(answer.file);
}

bool ReferenceDialog::saveAs(const QString& file) {
  if (!round_ || saving()) return false;
  savedName_ = QFileInfo(file).fileName();
  const std::filesystem::path path = file.toStdString();
  // Where the system has no thread to give, get() writes.
  saving_ = std::async(std::launch::async | std::launch::deferred,
                       [round = round_, carried = carried_, patient = hiddenInSaved(volume_), path] {
                         try {
                           write(round->image, carried, patient, path);
                           return QString();
                         } catch (const std::exception& error) {
                           return QString(error.what());
                         }
                       });
  save_->setEnabled(false);
  tell(tr("Saving %1…").arg(savedName_));
  saveTimer_.start();
  return true;
}

void ReferenceDialog::pollSaving() {
  if (saving_.wait_for(std::chrono::seconds(0)) == std::future_status::timeout) return;
  saveTimer_.stop();
  const QString problem = saving_.get();
  save_->setEnabled(round_ != nullptr);
  tell(problem.isEmpty() ? tr("Saved as %1").arg(savedName_) : problem, !problem.isEmpty());
}

}  // namespace isolux::ui
