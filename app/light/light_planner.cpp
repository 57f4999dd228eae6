#include "app/light/light_planner.h"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <utility>

#include <tbb/global_control.h>

#include "base/destroy_in_background.h"
#include "base/memory_budget.h"
#include "gi/arithmetic.h"
#include "gi/light_key.h"
#include "gi/trace/lattice_estimator.h"
#include "scene/rules/environment.h"
#include "scene/rules/relevance.h"
#include "scene/settings/settings.h"

namespace isolux::app {

namespace {

// A name that changes when the probe's file does.
std::string nameOf(const scene::Environment& settings) {
  std::ostringstream name;
  if (scene::kindOf(settings) == scene::EnvironmentKind::builtIn) {
    name << "built-in " << static_cast<int>(settings.builtIn);
    return std::move(name).str();
  }
  if (scene::hasOneColor(settings)) {
    const glm::dvec3& c = *settings.constant;
    name << std::hexfloat << "constant " << c.x << ' ' << c.y << ' ' << c.z;  // hexadecimal: exact
    return std::move(name).str();
  }
  std::error_code missing;
  const auto written = std::filesystem::last_write_time(settings.file, missing);
  return settings.file + '\n' + (missing ? "" : std::to_string(written.time_since_epoch().count()));
}

}  // namespace

std::vector<std::shared_ptr<gi::LightBake>> LightPlan::bakes() const {
  std::vector<std::shared_ptr<gi::LightBake>> list;
  for (const auto& bake : {sky, lamps, innerSky, innerLamps})
    if (bake) list.push_back(bake);
  return list;
}

// Without a setting, what --threads allows, else one per core.
int LightPlanner::threads() const {
  const std::size_t allowed = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return threads_.value_or(static_cast<int>(std::max<std::size_t>(1, allowed)));
}

const LightPlan& LightPlanner::plan(const scene::Scene& given, const VolumePointer& shown,
                                    base::Progress& progress) {
  if (shown != volumeOfFile_.lock()) texelsOfFile_.reset();
  const bool lights = scene::shadingOf(given) == scene::Shading::gi;
  const VolumePointer volume = lights ? volume::litVolume(shown, given, progress) : shown;
  scene_ = given;
  if (scene_.gi.texels == scene::GiTexels::automatic && texelsOfFile_) scene_.gi.texels = *texelsOfFile_;
  const scene::Scene& resolved = scene_;
  volume_ = volume;
  meterPending_ = groundPending_ = false;
  if (!volume || !lights) {
    // Stored light stays: the look may come back.
    if (!volume) stop();
    plan_ = {};
    plan_.choice = scene::giChoiceOf(resolved);
    takeBakes();
    wishNothing();
    return plan_;
  }
  loadEnvironment(resolved.light.environment);
  const scene::GiChoice choice = scene::giChoiceOf(resolved);
  if (choice.traced) {
    const TracerKey key{volume.get(), resolved.isosurface.inside,
                        volume::keyOf(volume::hiddenOf(resolved, *volume->pieces, progress)),
                        volume::SurfaceCut(resolved, volume->grid().geometry()).key()};
    if (!tracer_ || tracerOf_ != key) {
      const auto before = std::move(tracer_);  // its tables are shared
      tracer_ = gi::lightTracerOf(resolved, volume, progress);
      tracerOf_ = key;
    }
  }
  lightScene_ = gi::makeLightScene(resolved, volume, choice.traced ? tracer_ : nullptr, environment_);
  considerMetering(progress);
  considerGround(progress);
  require(outer_, lightScene_);
  requireInner(progress);
  if (choice.sky == scene::GiMode::transfer && projectedOrder_ != resolved.gi.shOrder) {
    projection_ = gi::projectEnvironment(*environment_, resolved.gi.shOrder);
    projectedOrder_ = resolved.gi.shOrder;
  }
  if (choice.sky != scene::GiMode::transfer || resolved.gi.components != basisComponents_ ||
      resolved.gi.componentBits != basisBits_)
    basis_.reset();
  plan_ = {};
  plan_.choice = choice;
  if (choice.wanted) {
    plan_.hidden = tracer_->hidden();
    plan_.arithmetic = gi::arithmeticOf(*tracer_);
    plan_.target = tracer_->target();
  }
  takeBakes();
  if (environment_->badPixels() > 0)
    plan_.warnings.push_back(std::to_string(environment_->badPixels()) +
                             " pixels of the environment map are negative or not numbers; replaced");
  if (choice.wanted && !choice.onShown && !tracer_->hidden().empty())
    plan_.warnings.emplace_back(
        "baked light includes hidden connected components; only light of one isosurface (gi.texels=shown) "
        "omits them");
  for (const auto& bake : plan_.bakes())
    if (const int wanted = threads(); bake->counters().threads < wanted)
      plan_.warnings.push_back("the system gives " + std::to_string(bake->counters().threads) + " of the " +
                               std::to_string(wanted) + " threads wanted for light");
  publish();
  return plan_;
}

void LightPlanner::loadEnvironment(const scene::Environment& settings) {
  std::string name = nameOf(settings);
  if (environment_ && name == environmentName_) return;
  const bool ofFile = scene::kindOf(settings) == scene::EnvironmentKind::file;
  environment_ = given_ && ofFile ? given_ : gi::loadEnvironment(settings);
  environmentName_ = std::move(name);
  projection_ = gi::projectEnvironment(*environment_, scene_.gi.shOrder);
  projectedOrder_ = scene_.gi.shOrder;
}

// At once, but after an isovalue that a user may still be dragging.
void LightPlanner::considerMetering(base::Progress& progress) {
  if (scene_.picture.metering == scene::Metering::lights || !lightScene_->choice.traced) {
    brightness_.reset();
    brightnessStage_ = {};
    return;
  }
  scene::Scene wanted = gi::meteredScene(scene_);
  const bool sameStage = brightnessStage_ == std::pair(volume_.get(), environmentName_);
  if (sameStage && wanted == brightnessOf_) return;
  for (std::size_t i = 0; i < std::min(wanted.surfaces.size(), brightnessOf_.surfaces.size()); ++i)
    wanted.surfaces[i].value = brightnessOf_.surfaces[i].value;
  if (background_ && sameStage && wanted == brightnessOf_)
    meterPending_ = true;
  else
    measureBrightness(progress);
}

void LightPlanner::measureBrightness(base::Progress& progress) {
  brightness_ = gi::measureBrightness(scene_, volume_, tracer_, environment_, progress);
  brightnessOf_ = gi::meteredScene(scene_);
  brightnessStage_ = {volume_.get(), environmentName_};
  meterPending_ = false;
}

// A window traces it when the scene rests: it takes as long as many frames.
void LightPlanner::considerGround(base::Progress& progress) {
  const std::uint64_t key = onlyPlans_ ? 0 : gi::groundKey(scene_, *lightScene_);
  groundPending_ = background_ && key != 0 && !(ground_ && ground_->key == key);
  if (key == 0)
    ground_.reset();
  else if (!groundPending_)
    ground_ = gi::makeGroundShadow(scene_, *lightScene_, ground_, progress);
}

void LightPlanner::finishAtRest(base::Progress& progress) {
  if (meterPending_) measureBrightness(progress);
  if (groundPending_) ground_ = gi::makeGroundShadow(scene_, *lightScene_, ground_, progress);
  groundPending_ = false;
  publish();
}

// What a part's lattice leaves for that of the next isovalue; while an isovalue is dragged too fast for any
// light, what was there before stays.
std::shared_ptr<const gi::LightLattice> LightPlanner::standIn(const Part& part) {
  std::shared_ptr<const gi::LightLattice> lattice = part.bake ? part.bake->lattice() : nullptr;
  if (!lattice || !lattice->geometry().isovalue ||
      lattice->content().kind != gi::LightContent::Kind::irradiance)
    return nullptr;
  const bool darker = part.before && part.before->bakedTexels() > lattice->bakedTexels();
  return darker ? part.before : lattice;
}

void LightPlanner::require(Side& side, const std::shared_ptr<const gi::LightScene>& light) {
  require(side.sky, light, gi::LightPart::sky, light->choice.sky != scene::GiMode::off);
  require(side.lamps, light, gi::LightPart::lamps, light->choice.lamps);
}

// Light of inner sides that are not seen any more stays as long as it is right.
void LightPlanner::requireInner(base::Progress& progress) {
  if (!innerSeen_ && !inner_.sky.bake && !inner_.lamps.bake) return;
  if (!lightScene_->choice.wanted) {
    require(inner_, lightScene_);
    return;
  }
  const std::shared_ptr<const gi::LightScene> light = gi::innerSideOf(*lightScene_, progress);
  const auto fits = [&](const Part& part, gi::LightPart which) {
    return !part.bake || part.key == gi::lightKey(scene_, *light, which);
  };
  if (innerSeen_ || (fits(inner_.sky, gi::LightPart::sky) && fits(inner_.lamps, gi::LightPart::lamps)))
    require(inner_, light);
  else
    stop(inner_);
}

void LightPlanner::require(Part& part, const std::shared_ptr<const gi::LightScene>& light,
                           gi::LightPart which, bool wanted) {
  if (!wanted) {
    keep(std::exchange(part, {}));
    return;
  }
  const std::string key = gi::lightKey(scene_, *light, which);
  if (part.bake && part.key == key) return demand(part);
  gi::LightScene ofAll = *light;
  ofAll.choice.onShown = false;
  const std::string keyOfAll = gi::lightKey(scene_, ofAll, which);
  std::shared_ptr<const gi::LightLattice> before;
  if (part.keyOfAll == keyOfAll) before = standIn(part);
  keep(std::exchange(part, {}));             // its threads end before those of the new one have much to do
  if (&part == &outer_.sky) basis_.reset();  // it was fitted to the old lattice
  if (std::optional<Part> again = kept(key)) {
    part = *std::move(again);
    return demand(part);
  }
  part.before = std::move(before);
  part.keyOfAll = keyOfAll;
  std::optional<float> isovalue;
  if (light->choice.onShown) isovalue = volume_->grid().storedIsovalue(scene::litIsovalue(scene_));
  const auto lattice = gi::LatticeGeometry::make(volume_->grid().dims(), scene_.gi.latticeScale, isovalue);
  part.key = key;
  part.estimator = std::make_shared<gi::LatticeEstimator>(light, lattice, which);
  part.bake = makeBake(part, std::make_shared<gi::LightLattice>(lattice, part.estimator->content(), key));
}

void LightPlanner::demand(const Part& part) {
  part.bake->setSamples(static_cast<std::uint32_t>(scene_.gi.samples));
  part.bake->setThreads(threads());
}

// In a window, where settings are tried and taken back. What had no time to become light is not worth it, nor
// what takes more than a part of the memory.
void LightPlanner::keep(Part part) {
  constexpr std::size_t most = 4, partOfMemory = 8;
  if (!part.bake) return;
  const std::shared_ptr<const gi::LightLattice> lattice = part.bake->lattice();
  const gi::BakeCounters counters = part.bake->counters();
  if (!background_ || lattice->bakedTexels() == 0 || 2 * counters.texelsSmooth < counters.texelsSeen ||
      part.bake->failure())
    return part.bake->requestStop();
  wishNothing(part);
  part.before.reset();
  kept_.push_front(std::move(part));
  std::size_t bytes = 0, fit = 0;
  while (fit < std::min(most, kept_.size()) &&
         (bytes += kept_[fit].bake->lattice()->bytes()) <= base::machineMemory().limit() / partOfMemory)
    ++fit;
  kept_.resize(fit);
}

std::optional<LightPlanner::Part> LightPlanner::kept(const std::string& key) {
  const auto found = std::ranges::find_if(kept_, [&](const Part& part) { return part.key == key; });
  if (found == kept_.end()) return std::nullopt;
  Part part = std::move(*found);
  kept_.erase(found);
  return part;
}

std::shared_ptr<gi::LightBake> LightPlanner::makeBake(const Part& part,
                                                      std::shared_ptr<gi::LightLattice> lattice) const {
  auto bake = std::make_unique<gi::LightBake>(
      std::move(lattice), part.estimator,
      gi::LightBake::Options{static_cast<std::uint32_t>(scene_.gi.samples), threads(), background_});
  // Whoever drops the last reference does not wait for its threads.
  return {bake.release(), [](gi::LightBake* dead) {
            dead->requestStop();
            base::destroyInBackground(std::unique_ptr<gi::LightBake>(dead));
          }};
}

void LightPlanner::adopt(std::shared_ptr<gi::LightLattice> lattice, gi::LightPart which) {
  Part& part = which == gi::LightPart::sky ? outer_.sky : outer_.lamps;
  if (part.bake) part.bake->requestStop();
  part.bake = makeBake(part, std::move(lattice));
  part.before.reset();
  part.asked.reset();
  takeBakes();
  basis_.reset();
  publish();
}

void LightPlanner::takeBakes() {
  plan_.sky = outer_.sky.bake;
  plan_.lamps = outer_.lamps.bake;
  plan_.innerSky = inner_.sky.bake;
  plan_.innerLamps = inner_.lamps.bake;
}

void LightPlanner::publish() {
  auto light = std::make_shared<gi::PictureLight>(gi::makePictureLight(scene_, *lightScene_, projection_));
  light->seen = brightness_;
  if (brightness_) light->automaticExposure = static_cast<float>(gi::exposureOf(*brightness_));
  const auto latticeOf = [](const Part& part) { return part.bake ? part.bake->lattice() : nullptr; };
  const auto store = [&](gi::StoredSide& stored, const Side& side) {
    stored = {latticeOf(side.sky), latticeOf(side.lamps), side.sky.before, side.lamps.before};
  };
  store(*light, outer_);
  store(light->inner, inner_);
  light->gloss = gloss_ = gi::makeGlossLight(scene_, lightScene_, gloss_.get());
  light->ground = ground_;
  light->basis = basis_;
  light->version = ++version_;
  plan_.light = std::move(light);
}

void LightPlanner::stop() {
  stop(outer_);
  stop(inner_);
  kept_.clear();
}

void LightPlanner::stop(Side& side) {
  for (Part* part : {&side.sky, &side.lamps}) {
    if (part->bake) part->bake->requestStop();
    *part = {};
  }
}

bool LightPlanner::compress(const base::Progress& progress) {
  if (!plan_.light || plan_.choice.sky != scene::GiMode::transfer || !outer_.sky.bake) return false;
  std::vector<const gi::LightLattice*> lattices;
  std::uint64_t texels = 0, revision = 0;
  bool idle = true;
  for (const Part* part : {&outer_.sky, &inner_.sky}) {
    if (!part->bake) continue;
    lattices.push_back(part->bake->lattice().get());
    texels += lattices.back()->bakedTexels();
    revision += lattices.back()->revision();
    idle = idle && part->bake->counters().idle;
  }
  constexpr std::uint64_t enoughForFirst = 64;
  const bool grown = texels >= std::max(enoughForFirst, basis_ ? 4 * basisTexels_ : 0);
  const bool settled = idle && texels > 0;
  if (revision == basisRevision_ && basis_) return false;
  if (!grown && !settled) return false;
  basis_ = gi::TransferBasis::fit(lattices, scene_.gi.components,
                                  scene_.gi.components * scene_.gi.componentBits, &progress);
  basisComponents_ = scene_.gi.components;
  basisBits_ = scene_.gi.componentBits;
  basisTexels_ = texels;
  basisRevision_ = revision;
  publish();
  return true;
}

}  // namespace isolux::app
