#include "ui/document/baked_light.h"

#include <algorithm>
#include <utility>

#include "scene/rules/relevance.h"

namespace isolux::ui {

namespace {

using Phase = app::LightState::Phase;

constexpr int busyMilliseconds = 33, calmMilliseconds = 250;
constexpr int stateMilliseconds = 200;  // progress is told this often
// Of the time between two pictures that only show more light, at most a fifth is drawing.
constexpr double partForBaking = 4.0;
constexpr double longestPauseMilliseconds = 1000.0;
constexpr double litEnough = 0.75;  // of what is seen: less looks patched
// After so many seconds of work it is known how long light takes; so many may be taken without asking.
constexpr double secondsOfTrial = 2.0, secondsUnasked = 20.0;

// Without what light depends on in no way: a view that turns is no news.
scene::Scene withoutView(scene::Scene scene) {
  scene.camera = {};
  scene.flow = {};
  scene.marks.clear();
  return scene;
}

// And in nothing else.
bool differInLight(scene::Scene a, const scene::Scene& b) {
  a.light = b.light;
  a.lamps = b.lamps;
  a.gi = b.gi;
  return a == b;
}

}  // namespace

BakedLight::BakedLight(QObject* parent) : QObject(parent), controller_({.background = true}) {
  connect(&timer_, &QTimer::timeout, this, &BakedLight::poll);
}

bool BakedLight::changing() const {
  if (cancelled_) return false;  // units of work that were begun are ended, nothing more
  return asked_ || state_.phase == Phase::preparing || state_.phase == Phase::baking;
}

void BakedLight::setVolume(VolumePointer volume) {
  volume_ = std::move(volume);
  hits_ = {};
  volumeIsNew_ = true;
  toldScene_ = false;
  light_.reset();
  shown_ = false;
  Q_EMIT lightChanged(light_, false, shown_);
}

void BakedLight::setScene(const scene::Scene& resolved) {
  scene::Scene wanted = withoutView(resolved);
  if (!volume_ || (toldScene_ && wanted == scene_)) return;
  const bool lit = scene::usesGi(wanted), begins = lit && !(toldScene_ && scene::usesGi(scene_));
  // What a change of light alone takes away is seen at once; the surface stays.
  if (!toldScene_ || !differInLight(scene_, wanted)) otherSurface_ = true;
  scene_ = std::move(wanted);
  toldScene_ = true;
  cancelled_ = false;
  if ((begins || !lit) && std::exchange(held_, false)) {
    controller_.setPaused(false);
    Q_EMIT answered();
  }
  if (begins && std::exchange(shown_, false)) Q_EMIT lightChanged(light_, true, shown_);
  controller_.setScene(resolved, volume_);
  asked_ = true;
  timer_.start(busyMilliseconds);
}

void BakedLight::setVisible(gi::VisiblePointSet hitVoxels, bool finer) {
  hits_ = std::move(hitVoxels);
  if (cancelled_ && finer) return;  // nobody has turned to anything new
  cancelled_ = false;
  otherSurface_ = otherSurface_ || !finer;
  controller_.setVisible(hits_);
  asked_ = true;
  timer_.start(busyMilliseconds);
}

void BakedLight::setPaused(bool paused) {
  controller_.setPaused(paused);
  takeState();
  timer_.start(busyMilliseconds);
}

void BakedLight::cancel() {
  cancelled_ = true;
  controller_.setPaused(false);
  controller_.cancel();
  takeState();
  timer_.start(busyMilliseconds);
}

void BakedLight::askFirst() {
  if (std::exchange(held_, false)) {
    controller_.setPaused(false);
    Q_EMIT answered();
  }
  asksFirst_ = true;
}

void BakedLight::goOn() {
  asksFirst_ = false;
  if (std::exchange(held_, false)) Q_EMIT answered();
  controller_.setPaused(false);
  if (std::exchange(cancelled_, false)) controller_.setVisible(hits_);
  takeState();
  timer_.start(busyMilliseconds);
}

double BakedLight::pauseBetweenPictures() const {
  return std::clamp(partForBaking * drawMilliseconds_, static_cast<double>(busyMilliseconds),
                    longestPauseMilliseconds);
}

void BakedLight::poll() {
  if (!volume_) {
    asked_ = false;
    timer_.stop();
    return;
  }
  if (volumeIsNew_ && !controller_.settle(0.0)) return;
  volumeIsNew_ = asked_ = false;
  const Phase before = state_.phase;
  state_ = controller_.state();
  if (state_.phase != before || !sinceState_.isValid() || sinceState_.elapsed() >= stateMilliseconds)
    takeState();
  considerShowing();
  considerAsking();

  const LightPointer light = controller_.light();
  const std::uint64_t revision = controller_.revision();
  const bool isChanging = changing(), other = light != light_;
  const bool due = !sincePicture_.isValid() ||
                   static_cast<double>(sincePicture_.elapsed()) >= pauseBetweenPictures() || !isChanging;
  if (other || isChanging != wasChanging_ || shown_ != wasShown_ || (revision != revision_ && due)) {
    light_ = light;
    revision_ = revision;
    wasChanging_ = isChanging;
    wasShown_ = shown_;
    sincePicture_.start();
    Q_EMIT lightChanged(light_, isChanging, shown_);
  }
  if (scene::shadingOf(scene_) != scene::Shading::gi && !isChanging) {
    timer_.stop();
  } else if (const int wanted = isChanging ? busyMilliseconds : calmMilliseconds;
             timer_.interval() != wanted) {
    timer_.start(wanted);
  }
}

void BakedLight::considerShowing() {
  if (!scene::usesGi(scene_)) return;
  const bool storesNone = state_.phase == Phase::off && !state_.choice.wanted;
  if (storesNone || state_.smooth == 1.0) {
    shown_ = true;
    otherSurface_ = false;
  } else if (state_.smooth && std::exchange(otherSurface_, false) && *state_.smooth < litEnough) {
    shown_ = false;
  }
}

void BakedLight::considerAsking() {
  if (!asksFirst_ || state_.phase == Phase::preparing) return;
  if (state_.phase == Phase::finished && !state_.smooth) return;  // nothing was asked for yet
  if (state_.phase != Phase::baking) {
    asksFirst_ = false;
  } else if (state_.counters.seconds >= secondsOfTrial && state_.counters.secondsLeft > secondsUnasked) {
    asksFirst_ = false;
    held_ = true;
    const double seconds = state_.counters.secondsLeft;
    setPaused(true);
    Q_EMIT takesLong(seconds);
  }
}

void BakedLight::takeState() {
  state_ = controller_.state();
  sinceState_.start();
  tellProblems();
  Q_EMIT stateChanged(state_, cancelled_);
}

void BakedLight::tellProblems() {
  const QString problem = state_.error ? QString::fromStdString(state_.error->what()) : QString();
  if (problem != std::exchange(problem_, problem) && !problem.isEmpty()) Q_EMIT failed(problem);
  QString warnings;
  for (const std::string& warning : state_.warnings)
    warnings += (warnings.isEmpty() ? "" : "; ") + QString::fromStdString(warning);
  if (warnings != std::exchange(warnings_, warnings) && !warnings.isEmpty()) Q_EMIT noted(warnings);
}

}  // namespace isolux::ui
