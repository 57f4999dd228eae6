#include "app/target/light_judge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stop_token>

#include "app/light/light_picture.h"
#include "app/study/light_truth.h"
#include "app/target/drawn_images.h"
#include "base/progress.h"
#include "gi/light_scene.h"

namespace isolux::app {

namespace {

// Paths of one of the truth's replicates: more where less noise is asked for, so that it takes some time, but
// not for ever where single paths are much brighter than the rest.
TruthOptions pathsFor(double noise) {
  constexpr double paths = 256.0, ordinaryNoise = 0.01, mostPaths = 4096.0;
  const double finer = std::max(ordinaryNoise / noise, 1.0);
  return {.firstSamples = 16,
          .mostSamples = static_cast<std::uint32_t>(std::min(paths * finer * finer, mostPaths)),
          .relativeNoise = noise};
}

bool canBeJudged(const TrueHit& hit) {
  return hit.hit && hit.fromOutside;
}

}  // namespace

LightJudge::LightJudge(render::Renderer& renderer, SurfaceTruth& truth,
                       std::shared_ptr<const volume::PreparedVolume> volume, const scene::Machine& machine,
                       render::FrameRequest picture, glm::ivec2 size, double noise)
    : renderer_(renderer),
      surface_(truth),
      volume_(std::move(volume)),
      picture_(std::move(picture)),
      size_(size),
      noise_(noise),
      controller_({.threads = machine.threads}) {}

// Light that stands still, whatever is stored of it.
const LightTruth& LightJudge::truthOf(Measuring measuring, base::Progress& progress) {
  const std::size_t count = std::min(judgedPixels(measuring), seen_);
  if (const auto known = truths_.find(count); known != truths_.end()) return known->second;
  scene::Scene still = *reference_;
  still.gi.mode = scene::GiMode::irradiance;
  still.light.environment.moves = false;
  still.gi.sequence = scene::DirectionSequence::sobol_owen;
  const auto environment = gi::loadEnvironment(still.light.environment);
  const auto light =
      gi::makeLightScene(still, volume_, gi::lightTracerOf(still, volume_, progress), environment);
  const double exposure = std::exp2(still.light.environment.exposure);
  const glm::dvec3 skyScale = light->choice.unitSky ? exposure * environment->mean() : glm::dvec3(exposure);
  std::vector<bool> isHit;
  isHit.reserve(hits_->size());
  for (const TrueHit& hit : *hits_) isHit.push_back(canBeJudged(hit));
  const std::vector<std::size_t> pixels = chosenPixels(isHit, count);
  std::vector<glm::vec3> voxels;
  voxels.reserve(pixels.size());
  for (const std::size_t pixel : pixels) voxels.emplace_back((*hits_)[pixel].voxel);
  const auto isovalue = volume_->grid().storedIsovalue(still.isosurface.value.value());
  return truths_
      .emplace(count, lightTruthAt(light, skyScale, isovalue, voxels, pixels, pathsFor(noise_), progress))
      .first->second;
}

void LightJudge::draw(const scene::Scene& scene, base::Progress& progress) {
  drawn_.reset();
  render::FrameRequest whole;
  whole.size = picture_.size;
  whole.color = false;
  whole.aovs = {render::Aov::depth, render::Aov::irradiance};
  whole.supersampling = picture_.aovs.empty() ? scene.picture.supersampling : 1;
  base::Progress inner;  // a bake's own fraction is not the search's
  const std::stop_callback stop(progress.token(), [&inner] { inner.requestStop(); });
  lightPicture(controller_, renderer_, scene, whole, volume_, inner);
  if (whole.supersampling > 1) {  // which casts no ray through a pixel's centre, where light is judged
    whole.supersampling = 1;
    lightPicture(controller_, renderer_, scene, whole, volume_, inner);
  }
  std::vector<std::vector<float>> drawn =
      drawnImages(renderer_, litScene(scene, whole), size_, whole.aovs, progress);
  const std::vector<float> depthMm = std::move(drawn[0]);
  irradiance_ = std::move(drawn[1]);
  for (std::size_t i = 0; i < hits_->size(); ++i) {
    const TrueHit& hit = (*hits_)[i];
    if (!hit.hit || !isFirstCrossing(static_cast<double>(depthMm[i]), hit))
      irradiance_[3 * i] = std::numeric_limits<float>::quiet_NaN();
  }
  drawn_ = scene;
}

LightErrors LightJudge::judge(const scene::Scene& scene, Measuring measuring, base::Progress& progress) {
  if (!reference_) {
    hits_ = &surface_.hitsOf(scene::Field::trilinear, progress);
    seen_ = static_cast<std::size_t>(std::count_if(hits_->begin(), hits_->end(), canBeJudged));
    reference_ = scene;
  }
  const LightTruth& truth = truthOf(measuring, progress);
  if (drawn_ != scene) draw(scene, progress);
  LightErrors errors = lightErrorsOf(irradiance_, truth);
  // Sampling without replacement: Cochran, Sampling Techniques (1977), eq. 2.20.
  const double part =
      std::min(1.0, static_cast<double>(judgedPixels(measuring)) / static_cast<double>(seen_));
  errors.rmseStandardError *= std::sqrt(1.0 - part);
  return errors;
}

}  // namespace isolux::app
