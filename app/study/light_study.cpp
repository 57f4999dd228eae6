#include "app/study/light_study.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stop_token>
#include <string_view>

#include "app/study/picture_study.h"
#include "base/quantiles.h"
#include "render/graph/pass.h"

namespace isolux::app {

namespace {

constexpr std::string_view kBounces = "bounces";
constexpr int kLeastBakes = 2;      // of each value, in turns
constexpr double kTruthPart = 0.2;  // of a knob's progress

double bounded(double from, double to, double part) {
  return from + (to - from) * std::min(part, 1.0);
}

// Light that stands still, baked as irradiance: what the truth is traced of.
scene::Scene still(scene::Scene scene, int bounces) {
  scene.gi.mode = scene::GiMode::irradiance;
  scene.light.environment.moves = false;
  scene.gi.bounces = bounces;
  scene.gi.sequence = scene::DirectionSequence::sobol_owen;
  return scene;
}

}  // namespace

struct LightStudio::Alternative {
  std::string value;
  scene::Scene scene;
  std::shared_ptr<const gi::PictureLight> light{};
  std::vector<double> bakes{}, lookups{}, frames{};  // seconds; ms
  LightCost cost{};
  std::vector<float> irradiance{};
  ComparedPicture picture{};
};

LightStudio::LightStudio(render::Renderer& renderer, SurfaceTruth& truth,
                         std::shared_ptr<const volume::PreparedVolume> volume, scene::Scene scene,
                         const scene::Machine& machine, glm::ivec2 size, int repeat)
    : renderer_(renderer),
      truth_(truth),
      volume_(std::move(volume)),
      scene_(std::move(scene)),
      size_(size),
      repeat_(repeat),
      controller_({.threads = machine.threads, .innerSides = false}) {}

void LightStudio::prepareHits(base::Progress& progress) {
  if (!hits_.empty()) return;
  hits_ = truth_.of(scene::Field::trilinear, scene::Field::cubic, progress).hits;
  for (const TrueHit& hit : hits_)
    hitVoxels_.push_back(hit.hit ? glm::vec3(hit.voxel) : glm::vec3(std::numeric_limits<float>::quiet_NaN()));
}

const LightTruth& LightStudio::truthOf(const scene::Scene& lit, int bounces, base::Progress& progress) {
  if (const auto found = truths_.find(bounces); found != truths_.end()) return found->second;
  const scene::Scene scene = still(lit, bounces);
  if (!environment_) environment_ = gi::loadEnvironment(scene.light.environment);
  if (!tracer_) tracer_ = gi::lightTracerOf(scene, volume_, progress);
  const auto light = gi::makeLightScene(scene, volume_, tracer_, environment_);
  const double exposure = std::exp2(scene.light.environment.exposure);
  const glm::dvec3 skyScale = light->choice.unitSky ? exposure * environment_->mean() : glm::dvec3(exposure);

  std::vector<bool> isHit;
  isHit.reserve(hits_.size());
  for (const TrueHit& hit : hits_) isHit.push_back(hit.hit && hit.fromOutside);
  const std::vector<std::size_t> pixels = chosenPixels(isHit, kTruthPixels);
  std::vector<glm::vec3> voxels;
  voxels.reserve(pixels.size());
  for (const std::size_t pixel : pixels) voxels.push_back(hitVoxels_[pixel]);
  const auto isovalue = volume_->grid().storedIsovalue(*scene.isosurface.value);
  return truths_.emplace(bounces, lightTruthAt(light, skyScale, isovalue, voxels, pixels, {}, progress))
      .first->second;
}

void LightStudio::bake(Alternative& alternative, bool anew, bool timed, base::Progress& progress) {
  if (anew) {
    scene::Scene dark = alternative.scene;
    dark.gi.mode = scene::GiMode::off;
    controller_.setScene(dark, volume_);
    while (!controller_.settle(0.05)) progress.throwIfStopped();  // or the planner sees the second alone
  }
  controller_.setScene(alternative.scene, volume_);
  controller_.setVisible({hitVoxels_});
  base::Progress inner;  // the bake's own fraction is not the study's
  const std::stop_callback stop(progress.token(), [&inner] { inner.requestStop(); });
  if (!controller_.finish(inner)) progress.throwIfStopped();
  const LightState state = controller_.state();
  alternative.light = controller_.light();
  alternative.cost.texels = state.counters.texelsWanted;
  alternative.cost.latticeBytes = 0;
  for (const auto& lattice : {alternative.light->sky, alternative.light->lamps})
    if (lattice) alternative.cost.latticeBytes += lattice->bytes();
  if (!timed) return;
  alternative.bakes.push_back(state.counters.seconds);
  alternative.cost.rays = state.counters.rays;
}

std::vector<float> LightStudio::draw(Alternative& alternative) {
  render::FrameRequest request;
  request.size = size_;
  request.color = false;
  request.aovs = {render::Aov::depth, render::Aov::irradiance};
  renderer_.setLight(alternative.light);
  const render::FrameReport& report = renderer_.render(alternative.scene, request);
  alternative.cost.gpuBytes = report.light.bytes;
  const std::vector<float> depthMm = renderer_.readAov(render::Aov::depth).values;
  std::vector<float> irradiance = renderer_.readAov(render::Aov::irradiance).values;
  for (std::size_t i = 0; i < hits_.size(); ++i)
    if (!hits_[i].hit || !isFirstCrossing(static_cast<double>(depthMm[i]), hits_[i]))
      irradiance[3 * i] = std::numeric_limits<float>::quiet_NaN();
  request.color = request.linear = true;
  request.aovs.clear();
  renderer_.render(alternative.scene, request);
  alternative.picture = comparedPicture(renderer_.readLinearPicture());
  return irradiance;
}

// One frame to warm up: it uploads the light.
void LightStudio::time(Alternative& alternative, int frames, base::Progress& progress) {
  render::FrameRequest request;
  request.size = size_;
  renderer_.setLight(alternative.light);
  renderer_.render(alternative.scene, request);
  for (int i = 0; i < frames; ++i) {
    progress.throwIfStopped();
    renderer_.invalidate();
    const render::FrameReport& report = renderer_.render(alternative.scene, request);
    alternative.frames.push_back(report.milliseconds);
    for (const render::PassReport& pass : report.passes)
      if (pass.name == render::pass::irradiance && pass.state == render::PassState::ran)
        alternative.lookups.push_back(pass.milliseconds);
  }
}

KnobStudy LightStudio::study(const Knob& knob, base::Progress& progress, double from, double to) {
  prepareHits(progress);
  std::vector<Alternative> alternatives;
  for (const char* const value : knob.values)
    alternatives.push_back({value, turned(knob, value, scene_, volume_->facts)});
  const bool bakes = knob.cost == Cost::bakeSeconds;
  const scene::Scene& lit = alternatives.front().scene;
  const scene::Scene given = scene::resolve(scene_, volume_->facts);

  KnobStudy result{.knob = knob, .settings = {}, .plot = {}};
  result.truthBounces = knob.name == kBounces ? kTruthBounces : given.gi.bounces;
  progress.report(from, "tracing the truth");
  const LightTruth& truth = truthOf(lit, result.truthBounces, progress);
  result.truthSamples = truth.samples;

  // Frames of values that share a bake are drawn in turns too, `repeat_` rounds of one.
  const int rounds = bakes ? std::max(kLeastBakes, repeat_ / 3) : repeat_;
  const int frames = bakes ? std::max(1, repeat_ / rounds) : 1;
  const double steps = static_cast<double>(alternatives.size()) * rounds;
  const double begin = bounded(from, to, kTruthPart);
  double done = 0.0;
  for (int round = 0; round < rounds; ++round)
    for (Alternative& alternative : alternatives) {
      progress.report(bounded(begin, to, done++ / steps), bakes || round == 0 ? "baking light" : "measuring");
      // The first anew: light of the knob before may be better than is asked for, and would be kept.
      const bool first = round == 0 && &alternative == &alternatives.front();
      if (bakes || round == 0) bake(alternative, bakes || first, bakes, progress);
      if (round == 0) alternative.irradiance = draw(alternative);
      time(alternative, frames, progress);
      if (bakes) alternative.light.reset();
    }
  renderer_.setLight(nullptr);

  const auto reference = std::find_if(alternatives.begin(), alternatives.end(), [&](const Alternative& a) {
    return a.value == pictureReference(knob);
  });
  for (Alternative& alternative : alternatives) {
    StudySetting setting;
    setting.value = alternative.value;
    setting.isDefault = alternative.value == defaultValue(knob);
    setting.frameMilliseconds = base::median(alternative.frames);
    setting.frameTimes = alternative.frames;
    alternative.cost.bakeSeconds =
        bakes ? base::median(alternative.bakes) : std::numeric_limits<double>::quiet_NaN();
    alternative.cost.lookupMilliseconds = base::median(alternative.lookups);
    alternative.cost.bakeTimes = alternative.bakes;
    alternative.cost.lookupTimes = alternative.lookups;
    setting.light = alternative.cost;
    setting.errors.pixels = hits_.size();
    setting.errors.light = lightErrorsOf(alternative.irradiance, truth);
    setting.errors.picture = pictureErrorsOf(alternative.picture, reference->picture);
    result.settings.push_back(std::move(setting));
  }
  return result;
}

}  // namespace isolux::app
