#include "ui/dialogs/reference_dialog.h"

#include <chrono>

#include <QComboBox>
#include <QFileInfo>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>

#include "app/documents/picture_scene.h"
#include "app/documents/session.h"
#include "app/files/image_io.h"
#include "app/files/reference_image.h"
#include "ui/document/picture_pixels.h"
#include "ui/document/privacy.h"
#include "ui/document/recent_files.h"
#include "ui/language/number_text.h"
#include "ui/theme/style.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/save_dialog.h"

namespace isolux::ui {

namespace {
constexpr int pollMilliseconds = 100, defaultSamples = 256;

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
      width_(spinBox(1, 16384, size.width(), tr("Width"), this)),
      height_(spinBox(1, 16384, size.height(), tr("Height"), this)),
      samples_(spinBox(1, 1000000, defaultSamples, tr("Paths per pixel"), this)),
      shown_(new QComboBox(this)),
      preview_(new QLabel(this)),
      text_(wrappedLabel({}, this)),
      bar_(thinBar(this)),
      start_(new QPushButton(tr("Trace"), this)),
      save_(new QPushButton(tr("Save…"), this)) {
  setWindowTitle(tr("Path-traced image"));
  resize(820, 640);
  preview_->setAlignment(Qt::AlignCenter);
  preview_->setMinimumSize(320, 240);
  preview_->setBackgroundRole(QPalette::Base);
  preview_->setAutoFillBackground(true);
  preview_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
  shown_->addItems({tr("Image"), tr("Noise (white: 10 % or more)")});
  shown_->setAccessibleName(tr("Display"));
  save_->setEnabled(false);
  start_->setDefault(true);

  auto* row = lineOf({new QLabel(tr("Size")), width_, new QLabel("×"), height_, Cell::gap(16),
                      new QLabel(tr("Paths per pixel")), samples_, Cell::room(), shown_});
  layOut(this, columnOf({row, {preview_, 1}, bar_, lineOf({{text_, 1}, start_, save_})}));
  tell(
      tr("Traces every pixel independently, without baked light. Twice as many paths take twice the time; "
         "four times as many halve the noise."));

  saveTimer_.setInterval(pollMilliseconds);
  connect(&saveTimer_, &QTimer::timeout, this, &ReferenceDialog::pollSaving);
  connect(start_, &QPushButton::clicked, this, &ReferenceDialog::startOrStop);
  connect(save_, &QPushButton::clicked, this, &ReferenceDialog::choose);
  connect(shown_, &QComboBox::currentIndexChanged, this, &ReferenceDialog::showImage);
}

void ReferenceDialog::tell(const QString& text, bool wrong) {
  text_->setText(text);
  setInk(text_, wrong ? Ink::error : Ink::quiet);
}

void ReferenceDialog::startOrStop() {
  if (tracing()) {
    task_->progress().requestStop();
    return;
  }
  round_.reset();
  start_->setText(tr("Stop"));
  left_.begin();
  task_.watch(
      app::referenceTask(volume_, resolved_, glm::ivec2(width_->value(), height_->value()),
                         static_cast<std::uint32_t>(samples_->value()), threads_),
      [this](auto& task) { takeEnd(task); }, [this] { showProgress(); });
}

void ReferenceDialog::takeRound(app::ReferenceTask& task) {
  if (app::RoundPointer round = task.take()) {
    round_ = std::move(round);
    save_->setEnabled(!saving());
    showImage();
  }
  showFraction(bar_, task.progress().fraction());
}

QString ReferenceDialog::noiseText() const {
  if (!round_ || !round_->noisePart) return {};
  return tr("noise %1 %").arg(numberText(100.0 * *round_->noisePart, 2));
}

void ReferenceDialog::showProgress() {
  takeRound(*task_);
  QStringList said{tr("Tracing…")};
  for (const QString& part : {noiseText(), left_.text(task_->progress().fraction())})
    if (!part.isEmpty()) said += part;
  tell(said.join(" · "));
}

void ReferenceDialog::takeEnd(app::ReferenceTask& task) {
  takeRound(task);
  start_->setText(tr("Trace"));
  const bool stopped = task.progress().stopRequested();
  if (task.error() && task.error()->kind() != base::ErrorKind::interrupted) {
    tell(QString::fromStdString(task.error()->what()), true);
  } else {
    const QString end = stopped ? tr("Stopped") : tr("Complete"), noise = noiseText();
    tell(noise.isEmpty() ? end : end + ": " + noise);
  }
}

void ReferenceDialog::showImage() {
  if (!round_) return;
  const QImage image = imageOf(shown_->currentIndex() == 0 ? round_->picture : round_->noise);
  preview_->setPixmap(
      QPixmap::fromImage(image).scaled(preview_->size(), Qt::KeepAspectRatio, Qt::SmoothTransformation));
}

void ReferenceDialog::resizeEvent(QResizeEvent* event) {
  QDialog::resizeEvent(event);
  showImage();
}

void ReferenceDialog::choose() {
  const QString file = askForFileToSave(
      this, tr("Save path-traced image"), lastFolder() + "/reference.exr",
      {tr("OpenEXR, linear colours, irradiance and variance (*.exr)"), tr("PNG, with session (*.png)")});
  if (file.isEmpty()) return;
  rememberFolder(file);
  saveAs(file);
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
