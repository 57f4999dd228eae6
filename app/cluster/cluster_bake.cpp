#include "app/cluster/cluster_bake.h"

#include <chrono>
#include <future>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/cluster/cluster_volume.h"
#include "app/cluster/rank_facts.h"
#include "app/light/light_resume.h"
#include "app/version.h"
#include "base/clock.h"
#include "base/error.h"
#include "gi/arithmetic.h"
#include "scene/rules/environment.h"
#include "scene/settings/settings.h"

namespace isolux::app {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// Where texels are lit in the file that may be gone on from.
std::optional<scene::GiTexels> texelsOfFile(const fs::path& out) {
  std::error_code missing;
  if (!fs::exists(out, missing)) return std::nullopt;
  try {
    return gi::isOfOneIsovalue(out) ? scene::GiTexels::shown : scene::GiTexels::own;
  } catch (const base::Error& error) {
    if (error.kind() != base::ErrorKind::input) throw;
    return std::nullopt;
  }
}

// Writes beside the bake: rank 0 goes on handing out tiles meanwhile.
class Checkpoints {
 public:
  void begin(std::function<void()> write) {
    end();
    try {
      writing_ = std::async(std::launch::async, write);
    } catch (const std::system_error&) {  // the system gives no thread
      write();
    }
  }
  bool busy() const {
    return writing_.valid() && writing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
  }
  void end() {  // throws what writing threw
    if (writing_.valid()) writing_.get();
  }

 private:
  std::future<void> writing_;
};

}  // namespace

void ClusterBake::sendScene(const std::string& path, ClusterScene& scene, base::Progress& progress) {
  const scene::Environment& light = scene.scene.light.environment;
  if (scene::kindOf(light) == scene::EnvironmentKind::file) scene.probe = gi::loadEnvironment(light);
  ClusterSetup setup;
  setup.version = version();
  setup.path = path;
  setup.scene = scene::toJson(scene.scene).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  setup.seen = scene.seen;
  setup.resumes = scene.texels.has_value();
  setup.ofOneIsovalue = scene.texels == scene::GiTexels::shown;
  setup.sendsVolume = options_.sendVolume;
  if (scene.probe) {
    setup.probeWidth = scene.probe->width();
    setup.probeHeight = scene.probe->height();
  }
  std::string bytes = bytesOf(setup);
  setUp_ = true;
  broadcastText(ranks_, bytes, progress);
  broadcastProbe(ranks_, scene.probe, setup.probeWidth, setup.probeHeight, progress);
  if (setup.sendsVolume) broadcastVolume(ranks_, scene.volume, progress);
}

gi::StoredLight ClusterBake::begin(const ClusterScene& scene, const ClusterLight& light,
                                   std::string& replaced, base::Progress& progress) const {
  gi::StoredLight stored;
  std::error_code missing;
  if (fs::exists(options_.out, missing)) {
    const auto keyOf = [](const auto& lattice) { return lattice ? lattice->key() : std::string(); };
    try {
      stored = gi::readBakeFile(options_.out, scene.volume->grid(), light.plan().hidden,
                                keyOf(light.working().sky), keyOf(light.working().lamps), progress);
    } catch (const base::Error& error) {
      if (error.kind() != base::ErrorKind::input) throw;
      replaced = error.reason();
    }
    if (replaced.empty())
      checkMayGoOn(options_.out, stored.facts, std::nullopt, light.plan().arithmetic, options_.mixArithmetic);
  }
  const gi::StoredLight fresh = light.fresh();
  if (!stored.sky) stored.sky = fresh.sky;
  if (!stored.lamps) stored.lamps = fresh.lamps;
  stored.facts.part.reset();
  if (scene.scene.gi.extent == scene::GiExtent::full)
    for (const auto& lattice : {stored.sky, stored.lamps})
      if (lattice) lattice->checkThatAllFits();
  return stored;
}

gi::StoredLight ClusterBake::stamped(const gi::StoredLight& finished) const {
  gi::StoredLight light = finished;
  light.facts.arithmetic = gi::joinedArithmetic(master_->arithmetic(), finished.facts.arithmetic);
  return light;
}

void ClusterBake::bake(const gi::StoredLight& finished, const ClusterScene& scene, base::Progress& progress) {
  const auto write = [this, &scene](const gi::StoredLight& light) {
    base::Progress writing;  // what there is, also when it ends here: writing is not stopped
    gi::writeBakeFile(options_.out, scene.volume->grid(), light, writing);
  };
  Checkpoints checkpoints;
  Clock::time_point written = Clock::now();
  Pause pause;
  while (!master_->isFinished() && !progress.stopRequested()) {
    const bool happened = master_->step();
    progress.report(master_->fraction(), "tracing light");
    if (base::secondsSince(written) >= options_.checkpointSeconds && !checkpoints.busy()) {
      checkpoints.begin([write, light = stamped(finished)] { write(light); });
      written = Clock::now();
    }
    pause.after(happened);
  }
  bakedSeconds_ = master_->seconds();
  checkpoints.end();
  write(stamped(finished));
  progress.throwIfStopped();
}

ClusterResult ClusterBake::run(const std::string& path, ClusterScene scene, base::Progress& progress) {
  scene.texels = texelsOfFile(options_.out);
  sendScene(path, scene, progress);
  light_.emplace(scene, options_.threads, progress);
  std::string replaced;
  gi::StoredLight finished = begin(scene, *light_, replaced, progress);
  ClusterMaster::Options options;
  options.mixArithmetic = options_.mixArithmetic;
  ClusterHello own = helloOf(*light_, scene.volume->grid(), options_.threads, options_.threadsAsked);
  master_.emplace(ranks_, *light_, std::move(own), finished, options);
  bake(finished, scene, progress);
  release();
  ClusterResult all = result(stamped(finished));
  if (!replaced.empty()) all.notes.insert(all.notes.begin(), replacedNote(options_.out, replaced));
  return all;
}

bool ClusterBake::release() {
  if (released_) return *released_;
  if (!setUp_) {
    ClusterSetup nothing;
    nothing.failed = true;
    std::string bytes = bytesOf(nothing);
    setUp_ = true;
    const base::Progress unstopped;
    broadcastText(ranks_, bytes, unstopped);
    released_ = true;
  } else if (master_) {
    released_ = master_->farewell(options_.farewellSeconds);
  } else {
    std::vector<RankReport> peers(static_cast<std::size_t>(ranks_.size()));
    peers[0].left = true;
    released_ = farewellTo(ranks_, peers, options_.farewellSeconds);
  }
  return *released_;
}

ClusterResult ClusterBake::result(const gi::StoredLight& finished) const {
  ClusterResult all;
  all.ranks = master_->reports();
  all.light = finished;
  LightState& state = all.state;
  state.phase = LightState::Phase::finished;
  state.choice = light_->plan().choice;
  state.mode = modeName(state.choice);
  state.warnings = light_->plan().warnings;
  state.counters.seconds = bakedSeconds_;
  for (const auto& lattice : {finished.sky, finished.lamps})
    if (lattice) state.counters.texelsLit += lattice->bakedTexels();
  for (std::size_t r = 0; r < all.ranks.size(); ++r) {
    const RankReport& rank = all.ranks[r];
    const std::string name = master_->nameOf(static_cast<int>(r));
    state.counters.samplesDone += rank.work.paths;
    state.counters.rays += rank.work.rays;
    state.counters.threads += rank.hello.threads;
    if (!rank.left)
      all.notes.push_back(name + " does not answer: the others have baked its tiles; the light is whole");
    if (rank.hello.bound) all.notes.push_back(boundNote(name, rank.hello.coresOfMachine));
  }
  return all;
}

}  // namespace isolux::app
