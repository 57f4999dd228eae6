#include "app/study/light_study.h"

#include <algorithm>
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
constexpr double kTruthPart = 0.2;  // of a quality setting's progress

double bounded(double from, double to, double part) {
  return from + (to - from) * std::min(part, 1.0);
}

}  // namespace

struct LightStudyRunner::Alternative {
  StudySetting setting;  // its value, and times and costs as they are measured
  scene::Scene scene;
  std::shared_ptr<const gi::PictureLight> light{};
  std::vector<float> irradiance{};
  ComparedPicture picture{};

  LightCost& cost() { return setting.light.value(); }
};

LightStudyRunner::LightStudyRunner(render::Renderer& renderer, SurfaceReference& truth,
                                   const StudySubject& subject)
    : renderer_(renderer),
      reference_(truth),
      subject_(subject),
      controller_({.threads = subject.host.threads, .innerSides = false}) {}

void LightStudyRunner::prepareHits(base::Progress& progress) {
  if (!hits_.empty()) return;
  hits_ = reference_.hitsOf(scene::Field::trilinear, progress);
  for (const TrueHit& hit : hits_)
    hitVoxels_.push_back(hit.hit ? glm::vec3(hit.voxel) : glm::vec3(std::numeric_limits<float>::quiet_NaN()));
}

const LightReference& LightStudyRunner::referenceOf(scene::Scene lit, int bounces, base::Progress& progress) {
  if (const auto found = references_.find(bounces); found != references_.end()) return found->second;
  lit.gi.bounces = bounces;
  return references_
      .emplace(bounces, lightReferenceOf(lit, subject_.volume, hits_, kTruthPixels, {}, progress))
      .first->second;
}

void LightStudyRunner::bake(Alternative& alternative, bool anew, bool timed, base::Progress& progress) {
  if (anew) {
    scene::Scene dark = alternative.scene;
    dark.gi.mode = scene::GiMode::off;
    controller_.setScene(dark, subject_.volume);
    while (!controller_.settle(0.05)) progress.throwIfStopped();  // or the planner sees the second alone
  }
  controller_.setScene(alternative.scene, subject_.volume);
  controller_.setVisible({hitVoxels_});
  base::Progress inner;  // the bake's own fraction is not the study's
  const std::stop_callback stop(progress.token(), [&inner] { inner.requestStop(); });
  if (!controller_.finish(inner)) progress.throwIfStopped();
  const LightState state = controller_.state();
  alternative.light = controller_.light();
  LightCost& cost = alternative.cost();
  cost.texels = state.counters.texelsWanted;
  cost.latticeBytes = 0;
  for (const auto& lattice : {alternative.light->sky, alternative.light->lamps})
    if (lattice) cost.latticeBytes += lattice->bytes();
  if (!timed) return;
  cost.bakeTimes.push_back(state.counters.seconds);
  cost.rays = state.counters.rays;
}

std::vector<float> LightStudyRunner::draw(Alternative& alternative) {
  const render::FrameRequest request{
      .size = subject_.size, .color = false, .aovs = {render::Aov::depth, render::Aov::irradiance}};
  renderer_.setLight(alternative.light);
  const render::FrameReport& report = renderer_.render(alternative.scene, request);
  alternative.cost().gpuBytes = report.light.bytes;
  const std::vector<float> depthMm = renderer_.readAov(render::Aov::depth).values;
  std::vector<float> irradiance = renderer_.readAov(render::Aov::irradiance).values;
  for (std::size_t i = 0; i < hits_.size(); ++i)
    if (!hits_[i].hit || !isFirstCrossing(static_cast<double>(depthMm[i]), hits_[i]))
      irradiance[3 * i] = std::numeric_limits<float>::quiet_NaN();
  alternative.picture = drawnPicture(renderer_, alternative.scene, subject_.size, 1);
  return irradiance;
}

// One frame to warm up: it uploads the light.
void LightStudyRunner::time(Alternative& alternative, int frames, base::Progress& progress) {
  const render::FrameRequest request{.size = subject_.size};
  renderer_.setLight(alternative.light);
  renderer_.render(alternative.scene, request);
  for (int i = 0; i < frames; ++i) {
    progress.throwIfStopped();
    renderer_.invalidate();
    const render::FrameReport& report = renderer_.render(alternative.scene, request);
    alternative.setting.frameTimes.push_back(report.milliseconds);
    for (const render::PassReport& pass : report.passes)
      if (pass.name == render::pass::irradiance && pass.state == render::PassState::ran)
        alternative.cost().lookupTimes.push_back(pass.milliseconds);
  }
}

QualityStudy LightStudyRunner::study(const QualitySetting& quality, base::Progress& progress, double from,
                                     double to) {
  prepareHits(progress);
  std::vector<Alternative> alternatives;
  for (const std::string& value : quality.values)
    alternatives.push_back(
        {{.value = value, .isDefault = value == defaultValue(quality), .light = LightCost{}},
         turned(quality, value, subject_.scene, subject_.volume->facts)});
  const bool bakes = quality.cost == Cost::bakeSeconds;
  const scene::Scene& lit = alternatives.front().scene;
  const scene::Scene given = scene::resolve(subject_.scene, subject_.volume->facts);

  QualityStudy result{.quality = quality};
  result.truthBounces = quality.name == kBounces ? kTruthBounces : given.gi.bounces;
  progress.report(from, "tracing the truth");
  const LightReference& truth = referenceOf(lit, result.truthBounces, progress);
  result.truthSamples = truth.samples;

  // Frames of values that share a bake are drawn in turns too, `subject_.repeat` rounds of one.
  const int rounds = bakes ? std::max(kLeastBakes, subject_.repeat / 3) : subject_.repeat;
  const int frames = bakes ? std::max(1, subject_.repeat / rounds) : 1;
  const double steps = static_cast<double>(alternatives.size()) * rounds;
  const double begin = bounded(from, to, kTruthPart);
  double done = 0.0;
  for (int round = 0; round < rounds; ++round)
    for (Alternative& alternative : alternatives) {
      progress.report(bounded(begin, to, done++ / steps), bakes || round == 0 ? "baking light" : "measuring");
      // The first anew: light of the quality setting before may be better than is asked for, and would be
      // kept.
      const bool first = round == 0 && &alternative == &alternatives.front();
      if (bakes || round == 0) bake(alternative, bakes || first, bakes, progress);
      if (round == 0) alternative.irradiance = draw(alternative);
      time(alternative, frames, progress);
      if (bakes) alternative.light.reset();
    }
  renderer_.setLight(nullptr);

  const auto reference = std::ranges::find_if(
      alternatives, [&](const Alternative& a) { return a.setting.value == quality.reference; });
  for (Alternative& alternative : alternatives) {
    StudySetting& setting = alternative.setting;
    LightCost& cost = alternative.cost();
    setMedians(setting);
    cost.bakeSeconds = bakes ? base::median(cost.bakeTimes) : std::numeric_limits<double>::quiet_NaN();
    cost.lookupMilliseconds = base::median(cost.lookupTimes);
    setting.errors.pixels = hits_.size();
    setting.errors.light = lightErrorsOf(alternative.irradiance, truth);
    setting.errors.picture = pictureErrorsOf(alternative.picture, reference->picture);
    result.settings.push_back(std::move(setting));
  }
  return result;
}

}  // namespace isolux::app
