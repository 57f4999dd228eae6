#include "app/light/light_controller.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <utility>

#include "app/light/light_planner.h"
#include "base/clock.h"
#include "base/destroy_in_background.h"
#include "gi/arithmetic.h"
#include "gi/file/bake_file.h"
#include "scene/settings/choice_names.h"

namespace isolux::app {

namespace {

using namespace std::chrono_literals;

constexpr auto restsAfter = 300ms;  // a scene that is dragged, for the exposure and the ground

void add(gi::BakeCounters& sum, const gi::BakeCounters& one) {
  sum.texelsWanted += one.texelsWanted;
  sum.texelsDone += one.texelsDone;
  sum.texelsStarted += one.texelsStarted;
  sum.texelsLit += one.texelsLit;
  sum.samplesWanted += one.samplesWanted;
  sum.samplesDone += one.samplesDone;
  sum.rays += one.rays;
  sum.raysPerSecond += one.raysPerSecond;
  sum.seconds = std::max(sum.seconds, one.seconds);
  sum.secondsLeft = std::max(sum.secondsLeft, one.secondsLeft);
  sum.threads = std::max(sum.threads, one.threads);
  sum.paused = sum.paused || one.paused;
  sum.idle = sum.idle && one.idle;
  sum.texelsSeen += one.texelsSeen;
  sum.texelsSmooth += one.texelsSmooth;
  sum.takenIn = sum.takenIn && one.takenIn;
}

// Without what the light does not depend on and a viewer changes from picture to picture: turning the view
// plans nothing anew, unless the exposure is that of the view.
scene::Scene lightOf(scene::Scene scene, bool metersView) {
  if (!metersView) scene.camera = {};
  scene.flow = {};
  const scene::Metering metering = scene.picture.metering;
  scene.picture = {};
  scene.picture.metering = metering;
  return scene;
}

// For display; what was no base::Error is a mistake of ours, and finish() throws it as it is.
base::Error described(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const base::Error& error) {
    return error;
  } catch (const std::bad_alloc&) {
    return {base::ErrorKind::memory, "", "light", "not enough memory"};
  } catch (const std::exception& error) {
    return {base::ErrorKind::input, "", "light", std::string("internal error: ") + error.what()};
  } catch (...) {
    return {base::ErrorKind::input, "", "light", "internal error"};
  }
}

}  // namespace

std::string modeName(const scene::GiChoice& choice) {
  const bool sky = choice.sky != scene::GiMode::off;
  std::string name(sky ? scene::choiceName(choice.sky) : choice.lamps ? "" : "off");
  if (choice.lamps) name += sky ? " + lamps" : "lamps";
  return name;
}

struct LightController::Parts {
  explicit Parts(Options options)
      : threads(options.threads), planner(options.background, options.innerSides, options.around) {
    planner.setPart(options.part);
  }

  // What the planner thread has to do; guarded by `mutex`.
  mutable std::mutex mutex;
  mutable std::condition_variable_any changed;
  scene::Scene scene;
  VolumePointer volume;
  bool metersView = false;
  std::optional<int> threads;
  std::optional<scene::GiTexels> texelsOfFile;  // for the next plan
  gi::VisiblePointSet hits;
  struct Told {
    bool scene = false, hits = false, cancel = false, compress = false;
    bool operator==(const Told&) const = default;
  };
  Told told;  // and not begun yet
  bool busy = false;
  bool planning =
      false;  // the planner thread is at work on `planner`, busy or only looking whether to compress

  // What it has done; guarded by `mutex`.
  LightPlan plan;
  std::exception_ptr failure;    // of the planner
  std::string loadedArithmetic;  // of the light that was loaded
  std::uint64_t planned = 0;
  bool paused = false, yielding = false;

  std::chrono::steady_clock::time_point toldAt;  // of the planner thread: when it was told anything last
  LightPlanner planner;                          // of the planner thread, and of load() while not `planning`
  base::Progress progress;                       // stops the planner's long work
  std::jthread thread;                           // last: it ends before the rest goes

  void run(const std::stop_token& stop);
  void work(const Told& now, const scene::Scene& given, const VolumePointer& of,
            const gi::VisiblePointSet& seen);
  void tell(bool Told::*what) {
    told.*what = true;
    changed.notify_all();
  }
  bool isIdle() const { return told == Told{} && !busy; }
  [[nodiscard]] LightPlan publish(const std::exception_ptr& failed);
  gi::StoredLight stored() const;
};

void LightController::Parts::run(const std::stop_token& stop) {
  std::unique_lock lock(mutex);
  while (!stop.stop_requested()) {
    const bool polls = plan.light && (plan.choice.sky == scene::GiMode::transfer || planner.isUnfinished());
    const auto isTold = [this] { return told != Told{}; };
    if (polls)
      changed.wait_for(lock, stop, 100ms, isTold);
    else
      changed.wait(lock, stop, isTold);
    if (stop.stop_requested()) return;
    busy = isTold();
    if (busy) toldAt = std::chrono::steady_clock::now();
    const Told now = std::exchange(told, {});
    const scene::Scene given = scene;
    const VolumePointer of = volume;
    planner.setThreads(threads);
    if (const auto texels = std::exchange(texelsOfFile, std::nullopt)) planner.setTexelsOfFile(*texels, of);
    // Looking whether to compress needs no points.
    const gi::VisiblePointSet seen = now.scene || now.hits ? hits : gi::VisiblePointSet();
    planning = true;
    lock.unlock();
    work(now, given, of, seen);
    lock.lock();
    busy = planning = false;
    changed.notify_all();
  }
}

void LightController::Parts::work(const Told& now, const scene::Scene& given, const VolumePointer& of,
                                  const gi::VisiblePointSet& seen) {
  std::exception_ptr failed;
  try {
    if (now.scene) planner.plan(given, of, progress);
    const bool otherLight = (now.scene || now.hits) && planner.request(seen, progress);
    if (now.cancel) planner.wishNothing();
    const bool compressed = planner.compress(progress);
    const bool rests = std::chrono::steady_clock::now() - toldAt >= restsAfter;
    const bool finished = planner.isUnfinished() && rests;
    if (finished) planner.finishAtRest(progress);
    if (!now.scene && !otherLight && !compressed && !finished) return;
  } catch (...) {
    failed = std::current_exception();
  }
  LightPlan before;  // goes with the mutex open
  const std::lock_guard guard(mutex);
  before = publish(failed);
}

// With `mutex` locked. Returns the plan before, for the caller to drop without it.
LightPlan LightController::Parts::publish(const std::exception_ptr& failed) {
  failure = failed;
  LightPlan before = std::exchange(plan, planner.current());
  if (failure) plan.light.reset();
  ++planned;
  for (const auto& bake : plan.bakes()) {
    bake->setPaused(paused);
    bake->yield(yielding);
  }
  return before;
}

LightController::LightController(Options options) : parts_(std::make_unique<Parts>(options)) {
  try {
    parts_->thread = std::jthread([parts = parts_.get()](const std::stop_token& stop) { parts->run(stop); });
  } catch (const std::system_error&) {
    throw base::Error(base::ErrorKind::memory, "", "light",
                      "cannot create a thread; raise the process limit (ulimit -u)");
  }
}

LightController::~LightController() {
  parts_->progress.requestStop();
  parts_->thread.request_stop();
  {
    const std::lock_guard guard(parts_->mutex);
    for (const auto& bake : parts_->plan.bakes()) bake->requestStop();
  }
  base::destroyInBackground(std::move(parts_));
}

void LightController::setScene(const scene::Scene& resolved,
                               std::shared_ptr<const volume::PreparedVolume> volume) {
  const std::lock_guard guard(parts_->mutex);
  const scene::Scene lit = lightOf(resolved, parts_->metersView);
  if (parts_->planned + (parts_->told.scene || parts_->busy ? 1 : 0) > 0 && lit == parts_->scene &&
      volume == parts_->volume)
    return;
  if (volume != parts_->volume) {
    parts_->hits = {};
    parts_->loadedArithmetic.clear();
  }
  parts_->scene = lit;
  parts_->volume = std::move(volume);
  parts_->tell(&Parts::Told::scene);
}

void LightController::meterView(bool view) {
  const std::lock_guard guard(parts_->mutex);
  parts_->metersView = view;
}

std::optional<double> LightController::viewExposure() const {
  const std::lock_guard guard(parts_->mutex);
  const auto& light = parts_->plan.light;
  if (!parts_->metersView || !light || !light->seen) return std::nullopt;
  return static_cast<double>(light->automaticExposure);
}

void LightController::setThreads(std::optional<int> threads) {
  const std::lock_guard guard(parts_->mutex);
  if (threads == parts_->threads) return;
  parts_->threads = threads;
  if (!parts_->volume) return;
  parts_->tell(&Parts::Told::scene);  // the plan is made with them
}

void LightController::setVisible(gi::VisiblePointSet hitVoxels) {
  const std::lock_guard guard(parts_->mutex);
  parts_->hits = std::move(hitVoxels);
  parts_->tell(&Parts::Told::hits);
}

void LightController::setPaused(bool paused) {
  const std::lock_guard guard(parts_->mutex);
  parts_->paused = paused;
  for (const auto& bake : parts_->plan.bakes()) bake->setPaused(paused);
}

bool LightController::paused() const {
  const std::lock_guard guard(parts_->mutex);
  return parts_->paused;
}

void LightController::yield(bool yielding) {
  const std::lock_guard guard(parts_->mutex);
  parts_->yielding = yielding;
  for (const auto& bake : parts_->plan.bakes()) bake->yield(yielding);
}

void LightController::cancel() {
  const std::lock_guard guard(parts_->mutex);
  parts_->tell(&Parts::Told::cancel);
}

std::shared_ptr<const gi::PictureLight> LightController::light() const {
  const std::lock_guard guard(parts_->mutex);
  return parts_->plan.light;
}

std::uint64_t LightController::revision() const {
  const std::lock_guard guard(parts_->mutex);
  std::uint64_t revision = parts_->planned << 40u;
  for (const auto& bake : parts_->plan.bakes()) revision += bake->lattice()->revision();
  return revision;
}

LightState LightController::state() const {
  using Phase = LightState::Phase;
  const std::lock_guard guard(parts_->mutex);
  const Parts& parts = *parts_;
  LightState state;
  state.choice = parts.plan.choice;
  state.mode = modeName(state.choice);
  std::exception_ptr failure = parts.failure;
  state.warnings = parts.plan.warnings;
  state.counters.idle = true;
  for (const auto& bake : parts.plan.bakes()) {
    add(state.counters, bake->counters());
    if (!failure) failure = bake->failure();
  }
  if (failure) state.error = described(failure);
  if (state.error)
    state.phase = Phase::failed;
  else if (parts.told.scene || (parts.busy && !parts.plan.light))
    state.phase = Phase::preparing;
  else if (!parts.plan.light || !state.choice.wanted)
    state.phase = Phase::off;
  else if (!state.counters.idle)
    state.phase = parts.paused ? Phase::paused : Phase::baking;
  else
    state.phase = parts.told.hits || parts.busy ? Phase::preparing : Phase::finished;
  const bool told = parts.told.scene || parts.told.hits || parts.busy || !state.counters.takenIn;
  if (!told && state.counters.texelsSeen > 0)
    state.smooth =
        static_cast<double>(state.counters.texelsSmooth) / static_cast<double>(state.counters.texelsSeen);
  return state;
}

bool LightController::settle(double timeoutSeconds) const {
  std::unique_lock lock(parts_->mutex);
  return parts_->changed.wait_for(lock, std::chrono::duration<double>(timeoutSeconds),
                                  [this] { return parts_->isIdle(); });
}

bool LightController::finish(base::Progress& progress, double timeoutSeconds) {
  const auto begin = std::chrono::steady_clock::now();
  const auto over = [&] { return progress.stopRequested() || base::secondsSince(begin) > timeoutSeconds; };
  constexpr double slice = 0.02;  // seconds: how soon a stop is seen
  while (!settle(slice))
    if (over()) return false;
  std::vector<std::shared_ptr<gi::LightBake>> bakes;
  {
    const std::lock_guard guard(parts_->mutex);
    if (parts_->failure) std::rethrow_exception(parts_->failure);
    bakes = parts_->plan.bakes();
  }
  for (const auto& bake : bakes) {
    while (!bake->waitFor(0, slice)) {
      if (const auto failed = bake->failure()) std::rethrow_exception(failed);
      if (over()) return false;
      const gi::BakeCounters counters = state().counters;
      const auto wanted = static_cast<double>(std::max<std::uint64_t>(counters.samplesWanted, 1));
      progress.report(static_cast<double>(counters.samplesDone) / wanted, "tracing light");
    }
  }
  // Threads put down what they were at; only then is what the planner compresses all that there will be.
  for (const auto& bake : bakes)
    while (!bake->counters().idle)
      if (over())
        return false;
      else
        std::this_thread::sleep_for(1ms);
  {
    const std::lock_guard guard(parts_->mutex);
    parts_->tell(&Parts::Told::compress);
  }
  while (!settle(slice))
    if (over()) return false;
  return true;
}

std::string LightController::arithmetic() const {
  const std::lock_guard guard(parts_->mutex);
  return parts_->plan.arithmetic;
}

gi::StoredLight LightController::Parts::stored() const {
  gi::StoredLight light;
  if (plan.sky) light.sky = plan.sky->lattice();
  if (plan.lamps) light.lamps = plan.lamps->lattice();
  light.facts.arithmetic = gi::joinedArithmetic(plan.arithmetic, loadedArithmetic);
  return light;
}

gi::StoredLight LightController::stored() const {
  const std::lock_guard guard(parts_->mutex);
  return parts_->stored();
}

void LightController::save(const std::filesystem::path& file, base::Progress& progress,
                           const std::optional<gi::BakedPart>& part) const {
  gi::StoredLight light;
  VolumePointer volume;
  {
    const std::lock_guard guard(parts_->mutex);
    light = parts_->stored();
    volume = parts_->volume;
  }
  if (!light.sky && !light.lamps) return;  // stopped before anything was planned
  light.facts.part = part;
  gi::writeBakeFile(file, volume->grid(), light, progress);
}

gi::BakeFacts LightController::load(const std::filesystem::path& file, base::Progress& progress) {
  const bool ofOne = gi::isOfOneIsovalue(file);
  {
    const std::lock_guard guard(parts_->mutex);
    parts_->texelsOfFile = ofOne ? scene::GiTexels::shown : scene::GiTexels::own;
    parts_->tell(&Parts::Told::scene);
  }
  while (!settle(0.05)) progress.throwIfStopped();
  VolumePointer volume;
  std::string skyKey, lampsKey;
  std::vector<volume::HiddenOfSurface> hidden;
  {
    const std::lock_guard guard(parts_->mutex);
    if (parts_->failure) std::rethrow_exception(parts_->failure);
    volume = parts_->volume;
    hidden = parts_->plan.hidden;
    if (parts_->plan.sky) skyKey = parts_->plan.sky->lattice()->key();
    if (parts_->plan.lamps) lampsKey = parts_->plan.lamps->lattice()->key();
  }
  gi::StoredLight stored = gi::readBakeFile(file, volume->grid(), hidden, skyKey, lampsKey, progress);
  LightPlan before;  // goes with the mutex open
  std::unique_lock lock(parts_->mutex);
  // From now on the planner thread sleeps: it begins nothing while the mutex is held.
  parts_->changed.wait(lock, [this] { return !parts_->planning; });
  if (stored.sky) parts_->planner.adopt(std::move(stored.sky), gi::LightPart::sky);
  if (stored.lamps) parts_->planner.adopt(std::move(stored.lamps), gi::LightPart::lamps);
  parts_->loadedArithmetic = stored.facts.arithmetic;
  before = parts_->publish(nullptr);
  parts_->tell(&Parts::Told::hits);
  return std::move(stored.facts);
}

}  // namespace isolux::app
