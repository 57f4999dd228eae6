#include "ui/accuracy/accuracy_panel.h"

#include <algorithm>

#include <QComboBox>
#include <QLabel>
#include <QSignalBlocker>

#include "scene/settings/settings.h"
#include "ui/accuracy/accuracy_chart.h"
#include "ui/accuracy/error_overlay_box.h"
#include "ui/accuracy/target_box.h"
#include "ui/language/number_text.h"
#include "ui/language/translated.h"
#include "ui/theme/style.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

namespace {

constexpr int accuracyRestMilliseconds = 1500;
constexpr glm::ivec2 measuredPixels{160, 120};
constexpr int measuredFrames = 3;

// What a study of any knob is of: the scene with all of them at their defaults.
scene::Scene withoutKnobs(scene::Scene scene) {
  for (const app::QualitySetting& knob : app::knobs()) {
    const scene::Setting& setting = scene::setting(knob.setting);
    setting.set(scene, setting.defaultValue());
  }
  scene.marks.clear();
  scene.picture = {};
  return scene;
}

QString labelOf(const app::QualitySetting& knob) {
  return wordsOf(QString(knob.label));
}

// In the order of app::Cost.
constexpr const char* kCostTexts[] = {
    QT_TRANSLATE_NOOP("isolux::ui::AccuracyPanel", "render time of these passes, ms"),
    QT_TRANSLATE_NOOP("isolux::ui::AccuracyPanel", "render time, ms"),
    QT_TRANSLATE_NOOP("isolux::ui::AccuracyPanel", "light computation time, s"),
    QT_TRANSLATE_NOOP("isolux::ui::AccuracyPanel", "light lookup time, ms"),
    QT_TRANSLATE_NOOP("isolux::ui::AccuracyPanel", "graphics memory, MiB")};
// In the order of app::Measure; of shadows, which no point of a plot has, the last.
constexpr const char* kErrorTexts[] = {
    QT_TRANSLATE_NOOP("isolux::ui::AccuracyPanel", "depth error, voxels"),
    QT_TRANSLATE_NOOP("isolux::ui::AccuracyPanel", "normal error, degrees"),
    QT_TRANSLATE_NOOP("isolux::ui::AccuracyPanel", "relative curvature error"),
    QT_TRANSLATE_NOOP("isolux::ui::AccuracyPanel", "relative light error"),
    QT_TRANSLATE_NOOP("isolux::ui::AccuracyPanel", "error at edges, fraction of the range"),
    QT_TRANSLATE_NOOP("isolux::ui::AccuracyPanel", "error at edges, fraction of the range")};

}  // namespace

AccuracyPanel::AccuracyPanel(QWidget* parent)
    : Panel(parent),
      picture_(new PictureAccuracy(this)),
      target_(new TargetBox(this)),
      overlay_(new ErrorOverlayBox(this)),
      knobs_(new QComboBox(this)),
      chart_(new AccuracyChart(this)),
      state_(wrappedLabel({}, this)),
      meaning_(wrappedLabel({}, this)),
      key_(wrappedLabel(
          tr("Square: current setting. Ring: default. Dashed line: no other value is as accurate "
             "in less time. Click a point to use its value."),
          this)) {
  knobs_->setAccessibleName(tr("Quality setting (accuracy against time)"));
  for (QLabel* label : {state_, key_}) setInk(label, Ink::quiet);
  layOut(this, columnOf({knobs_, meaning_, {chart_, 1}, key_, state_, target_, overlay_}, 8),
         {12, 10, 12, 12});

  connect(picture_, &PictureAccuracy::changed, this, &AccuracyPanel::tellPicture);
  connect(picture_, &PictureAccuracy::ended, this, &AccuracyPanel::measure);
  connect(target_, &TargetBox::edited, this, &Panel::edited);
  connect(target_, &TargetBox::limitChanged, this, &AccuracyPanel::showOverlay);
  connect(overlay_, &ErrorOverlayBox::wantedChanged, this, &AccuracyPanel::wantOverlay);
  connect(overlay_, &ErrorOverlayBox::painted, this, &AccuracyPanel::overlayPainted);
  connect(target_, &TargetBox::searchingChanged, this,
          [this] { target_->searching() ? drop() : measureSoon(); });
  connect(knobs_, &QComboBox::currentIndexChanged, this, &AccuracyPanel::showKnob);
  connect(chart_, &AccuracyChart::chosen, this, &AccuracyPanel::choose);
  callOnce(restTimer_, accuracyRestMilliseconds, this, &AccuracyPanel::measure);

  showKnob();
}

// What is told

void AccuracyPanel::setVolume(const VolumePointer& volume) {
  drop();
  volume_ = volume;
  measured_.clear();
  acting_.clear();
  trouble_.clear();
  complete_ = false;
  drawn_ = {};
  drawn_.request.size = glm::ivec2(0);
  pixels_ = {};
  picture_->forget();
  showPicture();
  showTarget();
  listKnobs();
}

void AccuracyPanel::setScene(const scene::Scene& scene, const scene::Scene& resolved) {
  scene_ = scene;
  resolved_ = resolved;
  showPicture();
  showTarget();
  if (!isSeen(this)) {
    drop();
    return;
  }
  scene::Scene subject = withoutKnobs(scene);
  if (!(subject == subject_)) {
    subject_ = std::move(subject);
    trouble_.clear();
    drop();
  }
  listKnobs();
  measureSoon();
}

void AccuracyPanel::seenChanged() {
  showPicture();
  if (!isSeen(this)) {
    drop();
    target_->drop();
  }
}

void AccuracyPanel::setDrawing(bool draws) {
  drawing_ = draws;
  if (!isSeen(this)) return;
  if (draws)
    drop();
  else
    measureSoon();
}

// A tab that comes to the front is painted.
void AccuracyPanel::paintEvent(QPaintEvent* event) {
  Panel::paintEvent(event);
  if (task_ || restTimer_.isActive() || !volume_) return;
  subject_ = withoutKnobs(scene_);
  if (acting_.empty()) listKnobs();
  showPicture();
  showTarget();
  measureSoon();
}

void AccuracyPanel::hideEvent(QHideEvent* event) {
  Panel::hideEvent(event);
  seenChanged();
}

void AccuracyPanel::listKnobs() {
  std::vector<app::QualitySetting> acting;
  if (volume_) acting = app::actingQualitySettings(scene_, volume_->facts);
  const auto sameNames = [](const app::QualitySetting& a, const app::QualitySetting& b) {
    return std::string_view(a.name) == b.name;
  };
  if (!std::equal(acting.begin(), acting.end(), acting_.begin(), acting_.end(), sameNames)) {
    const QString before = knobs_->currentData().toString();
    acting_ = std::move(acting);
    const QSignalBlocker block(knobs_);
    knobs_->clear();
    for (const app::QualitySetting& each : acting_) knobs_->addItem(labelOf(each), QString(each.name));
    if (const int at = knobs_->findData(before); at >= 0) knobs_->setCurrentIndex(at);
  }
  showKnob();
}

// Measuring

std::vector<app::QualitySetting> AccuracyPanel::missing() const {
  std::vector<app::QualitySetting> list;
  for (const app::QualitySetting& each : acting_) {
    const auto found = measured_.find(each.name);
    if (found == measured_.end() || !(found->second.of == subject_)) list.push_back(each);
  }
  const std::string first = knobs_->currentData().toString().toStdString();  // what is looked at
  std::stable_partition(list.begin(), list.end(),
                        [&](const app::QualitySetting& each) { return first == each.name; });
  return list;
}

bool AccuracyPanel::complete() const {
  return volume_ && !acting_.empty() && missing().empty();
}

void AccuracyPanel::measureSoon() {
  if (!isSeen(this)) return;
  const bool idle = volume_ && !drawing_ && !task_ && !target_->searching() && !picture_->working();
  if (idle && (picture_->wanted() || (trouble_.isEmpty() && !missing().empty()))) restTimer_.start();
  showState();
}

void AccuracyPanel::measure() {
  if (!isSeen(this) || !volume_ || drawing_ || task_ || target_->searching()) return;
  picture_->measure();
  if (picture_->working() || !trouble_.isEmpty()) return showState();
  std::vector<app::QualitySetting> wanted = missing();
  if (wanted.empty()) return;
  scene::HostSettings host;
  host.executor = scene::Executor::cpu;  // the volume is on the graphics card once, for the user
  task_.watch(
      app::studyTask({volume_, subject_, host, measuredPixels, measuredFrames}, std::move(wanted)),
      [this](auto& task) { takeLast(task); }, [this] { takeStudies(*task_); });
  ++jobsBegun_;
  showState();
}

void AccuracyPanel::drop() {
  restTimer_.stop();
  task_.reset();
  picture_->drop();
  showState();
}

void AccuracyPanel::takeLast(app::StudyTask& task) {
  if (task.error()) trouble_ = QString::fromStdString(task.error()->what());
  takeStudies(task);
}

void AccuracyPanel::takeStudies(app::StudyTask& task) {
  std::vector<app::QualityStudy> found = task.take();
  for (app::QualityStudy& study : found) {
    const std::string name = study.knob.name;
    measured_.insert_or_assign(name, Measured{std::move(study), subject_});
  }
  if (!found.empty())
    showKnob();
  else
    showState();
}

// What is shown

const app::QualitySetting* AccuracyPanel::knob() const {
  const int at = knobs_->currentIndex();
  return at < 0 || at >= static_cast<int>(acting_.size()) ? nullptr : &acting_[static_cast<std::size_t>(at)];
}

void AccuracyPanel::showKnob() {
  const app::QualitySetting* const shown = knob();
  knobs_->setVisible(shown != nullptr);
  key_->setVisible(shown != nullptr);
  meaning_->setVisible(shown != nullptr);
  if (shown) {
    meaning_->setText(translated(texts::settings, scene::setting(shown->setting).meaning));
    const auto found = measured_.find(shown->name);
    std::vector<app::QualityPoint> points;
    if (found != measured_.end()) points = app::pointsOf(found->second.study, scene_, volume_->facts);
    chart_->show(std::move(points), tr(kCostTexts[static_cast<std::size_t>(shown->cost)]),
                 tr(kErrorTexts[static_cast<std::size_t>(shown->measure)]));
  } else {
    chart_->show({}, {}, {});
  }
  showState();
}

QString AccuracyPanel::state() const {
  return state_->text();
}

void AccuracyPanel::showState() {
  if (!volume_) return state_->setText(tr("Open a volume to plot its accuracy against render time."));
  if (!trouble_.isEmpty()) return state_->setText(trouble_);
  const app::QualitySetting* const shown = knob();
  const auto found = shown ? measured_.find(shown->name) : measured_.end();
  const bool stale = found != measured_.end() && !(found->second.of == subject_);
  QString text = picture_->working() ? tr("Measuring the image on screen…")
                 : task_ ? tr("Measuring… %1 %").arg(qRound(100.0 * task_->progress().fraction()))
                 : missing().empty() ? QString()
                                     : tr("Waiting until the window is idle");
  if (found != measured_.end()) {
    if (!text.isEmpty()) text += ". ";
    text += stale ? tr("This chart belongs to an earlier view or scene")
                  : tr("Measured on the CPU at %1 × %2 pixels of this view, against double precision")
                        .arg(measuredPixels.x)
                        .arg(measuredPixels.y);
    if (!found->second.study.skipped.empty()) text = QString::fromStdString(found->second.study.skipped);
  }
  state_->setText(text);
}

void AccuracyPanel::choose(const QString& value) {
  const app::QualitySetting* const shown = knob();
  if (!shown || !volume_) return;
  Edit edit{scene_, tr("Change %1").arg(nameOf(scene::setting(shown->setting))), {}, false};
  edit.scene = app::withQualitySettingAt(*shown, value.toStdString(), scene_, volume_->facts);
  if (!(edit.scene == scene_)) Q_EMIT edited(edit);
}

}  // namespace isolux::ui
