#include "ui/accuracy/accuracy_panel.h"

#include <algorithm>

#include <QComboBox>
#include <QSignalBlocker>

#include "render/passes/pass_declarations.h"
#include "scene/rules/needs.h"
#include "scene/settings/settings.h"
#include "ui/accuracy/accuracy_chart.h"
#include "ui/accuracy/accuracy_text.h"
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

// What a study of any quality setting is of: the scene with all of them at their defaults.
scene::Scene withDefaultQualities(scene::Scene scene) {
  for (const app::QualitySetting& quality : app::qualitySettings()) {
    const scene::Setting& setting = scene::setting(quality.setting);
    setting.set(scene, setting.defaultValue());
  }
  scene.marks.clear();
  scene.picture = {};
  return scene;
}

QString labelOf(const app::QualitySetting& quality) {
  return wordsOf(QString(quality.label));
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
      qualities_(new QComboBox(this)),
      chart_(new AccuracyChart(this)),
      state_(wrappedLabel({}, this)),
      meaning_(wrappedLabel({}, this)),
      key_(wrappedLabel(
          tr("Square: current setting. Ring: default. Dashed line: no other value is as accurate "
             "in less time. Click a point to use its value."),
          this)) {
  qualities_->setAccessibleName(tr("Quality setting (accuracy against time)"));
  for (QLabel* label : {state_, key_}) setInk(label, Ink::quiet);
  layOut(this, columnOf({qualities_, meaning_, {chart_, 1}, key_, state_, target_, overlay_}, 8),
         {12, 10, 12, 12});

  connect(picture_, &PictureAccuracy::changed, this, &AccuracyPanel::tellPicture);
  connect(picture_, &PictureAccuracy::ended, this, &AccuracyPanel::measure);
  connect(target_, &TargetBox::edited, this, &Panel::edited);
  connect(target_, &TargetBox::limitChanged, this, &AccuracyPanel::showOverlay);
  connect(overlay_, &ErrorOverlayBox::wantedChanged, this, &AccuracyPanel::wantOverlay);
  connect(overlay_, &ErrorOverlayBox::painted, this, &AccuracyPanel::overlayPainted);
  connect(target_, &TargetBox::searchingChanged, this,
          [this] { target_->searching() ? drop() : measureSoon(); });
  connect(qualities_, &QComboBox::currentIndexChanged, this, &AccuracyPanel::showQuality);
  connect(chart_, &AccuracyChart::chosen, this, &AccuracyPanel::choose);
  callOnce(restTimer_, accuracyRestMilliseconds, this, &AccuracyPanel::measure);

  showQuality();
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
  listQualities();
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
  scene::Scene subject = withDefaultQualities(scene);
  if (!(subject == subject_)) {
    subject_ = std::move(subject);
    trouble_.clear();
    drop();
  }
  listQualities();
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
  subject_ = withDefaultQualities(scene_);
  if (acting_.empty()) listQualities();
  showPicture();
  showTarget();
  measureSoon();
}

void AccuracyPanel::hideEvent(QHideEvent* event) {
  Panel::hideEvent(event);
  seenChanged();
}

void AccuracyPanel::listQualities() {
  std::vector<app::QualitySetting> acting;
  if (volume_) acting = app::actingQualitySettings(scene_, volume_->facts);
  const auto sameNames = [](const app::QualitySetting& a, const app::QualitySetting& b) {
    return std::string_view(a.name) == b.name;
  };
  if (!std::equal(acting.begin(), acting.end(), acting_.begin(), acting_.end(), sameNames)) {
    const QString before = qualities_->currentData().toString();
    acting_ = std::move(acting);
    const QSignalBlocker block(qualities_);
    qualities_->clear();
    for (const app::QualitySetting& each : acting_) qualities_->addItem(labelOf(each), QString(each.name));
    if (const int at = qualities_->findData(before); at >= 0) qualities_->setCurrentIndex(at);
  }
  showQuality();
}

// Measuring

std::vector<app::QualitySetting> AccuracyPanel::missing() const {
  std::vector<app::QualitySetting> list;
  for (const app::QualitySetting& each : acting_) {
    const auto found = measured_.find(each.name);
    if (found == measured_.end() || !(found->second.of == subject_)) list.push_back(each);
  }
  const std::string first = qualities_->currentData().toString().toStdString();  // what is looked at
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
      [this](auto& task) {
        if (task.error()) trouble_ = QString::fromStdString(task.error()->what());
        takeStudies(task);
      },
      [this] { takeStudies(*task_); });
  ++jobsBegun_;
  showState();
}

void AccuracyPanel::drop() {
  restTimer_.stop();
  task_.reset();
  picture_->drop();
  showState();
}

void AccuracyPanel::takeStudies(app::StudyTask& task) {
  std::vector<app::QualityStudy> found = task.take();
  for (app::QualityStudy& study : found) {
    const std::string name = study.quality.name;
    measured_.insert_or_assign(name, Measured{std::move(study), subject_});
  }
  if (!found.empty())
    showQuality();
  else
    showState();
}

// What is shown

const app::QualitySetting* AccuracyPanel::quality() const {
  const int at = qualities_->currentIndex();
  return at < 0 || at >= static_cast<int>(acting_.size()) ? nullptr : &acting_[static_cast<std::size_t>(at)];
}

void AccuracyPanel::showQuality() {
  const app::QualitySetting* const shown = quality();
  qualities_->setVisible(shown != nullptr);
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

void AccuracyPanel::showState() {
  if (!volume_) return state_->setText(tr("Open a volume to plot its accuracy against render time."));
  if (!trouble_.isEmpty()) return state_->setText(trouble_);
  const app::QualitySetting* const shown = quality();
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
  const app::QualitySetting* const shown = quality();
  if (!shown || !volume_) return;
  Edit edit{scene_, tr("Change %1").arg(nameOf(scene::setting(shown->setting))), {}, false};
  edit.scene = app::withQualitySettingAt(*shown, value.toStdString(), scene_, volume_->facts);
  if (!(edit.scene == scene_)) Q_EMIT edited(edit);
}

// The picture on screen: when it is measured, what is said of it, and what searches are of

void AccuracyPanel::setReport(const render::FrameReport& report, const render::FrameRequest& request) {
  reported_ = {request, app::castsOnProcessor(report)};
}

void AccuracyPanel::setHostSettings(const scene::HostSettings& host) {
  host_ = host;
  showTarget();
}

void AccuracyPanel::setLight(const LightPointer& light, bool changing) {
  light_ = light;
  lightChanging_ = changing;
  if (!isSeen(this)) return;
  showPicture();
  showTarget();
}

void AccuracyPanel::setPreviewing(bool previews) {
  previewing_ = previews;
  showPicture();
}

void AccuracyPanel::setComplete(bool complete) {
  complete_ = complete;
  if (complete) drawn_ = reported_;
  if (!isSeen(this)) return;
  showPicture();
  showTarget();
  measureSoon();
}

void AccuracyPanel::setPixels(std::function<QImage()> picture, const std::optional<render::Tile>& legend) {
  pixels_ = std::move(picture);
  legend_ = legend;
  showOverlay();
}

// What the user has just asked to see goes before what nobody has.
void AccuracyPanel::wantOverlay() {
  picture_->keepImages(overlay_->wanted());
  if (overlay_->wanted() && picture_->wanted()) task_.reset();
  restTimer_.stop();
  measure();
  showOverlay();
}

void AccuracyPanel::showOverlay() {
  ErrorOverlayBox::Shown shown;
  if (volume_ && overlay_->wanted()) {
    shown.errors = picture_->images();
    if (shown.errors && pixels_) shown.picture = pixels_();
    const glm::dvec3 edges = volume_->grid().geometry().spacingMm();
    shown.shortestEdgeMm = std::min({edges.x, edges.y, edges.z});
    shown.corner = resolved_.look.legendCorner;
    shown.legend = legend_;
    shown.limit = target_->limit();
  }
  overlay_->setShown(shown);
}

void AccuracyPanel::showPicture() {
  const bool lit = scene::usesGi(resolved_);
  if (!isSeen(this) || !volume_ || !complete_ || previewing_ || (lit && lightChanging_))
    return picture_->show({});
  picture_->show(PictureAccuracy::Subject{{volume_, resolved_, lit ? light_ : nullptr, drawn_.request.size},
                                          drawn_.onProcessor});
}

void AccuracyPanel::tellPicture() {
  const std::optional<app::Accuracy>& known = picture_->known();
  if (!known)
    Q_EMIT pictureKnown({}, {});
  else
    Q_EMIT pictureKnown(accuracyText(*known, render::readsHessian(resolved_, drawn_.request)),
                        accuracyMeaning(*known));
  showOverlay();
  showState();
}

void AccuracyPanel::showTarget() {
  app::TargetSubject subject;
  if (isSeen(this)) {
    subject.volume = volume_;
    subject.given = scene_;
    subject.picture.size = drawn_.request.size;
    subject.picture.supersampling = std::clamp(resolved_.picture.supersampling, 1, 4);
    subject.picture.pixelRatio = drawn_.request.pixelRatio;
    subject.host = host_;
    subject.light = light_;
  }
  target_->setSubject(subject);
}

}  // namespace isolux::ui
