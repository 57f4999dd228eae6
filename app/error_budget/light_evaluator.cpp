#include "app/error_budget/light_evaluator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stop_token>

#include "app/error_budget/drawn_images.h"
#include "app/light/light_picture.h"
#include "app/study/light_reference.h"
#include "base/progress.h"

namespace isolux::app {

namespace {

// Paths of one of the truth's replicates: more where less noise is asked for, so that it takes some time, but
// not for ever where single paths are much brighter than the rest.
LightReferenceOptions pathsFor(double noise) {
  constexpr double paths = 256.0, ordinaryNoise = 0.01, mostPaths = 4096.0;
  const double finer = std::max(ordinaryNoise / noise, 1.0);
  return {.firstSamples = 16,
          .mostSamples = static_cast<std::uint32_t>(std::min(paths * finer * finer, mostPaths)),
          .relativeNoise = noise};
}

}  // namespace

LightEvaluator::LightEvaluator(render::Renderer& renderer, SurfaceReference& reference,
                               const TargetQuestion& question, glm::ivec2 size, double noise)
    : renderer_(renderer),
      surface_(reference),
      question_(question),
      size_(size),
      noise_(noise),
      controller_({.threads = question.host.threads}) {}

const LightReference& LightEvaluator::referenceOf(Measuring measuring, base::Progress& progress) {
  const std::size_t count = std::min(judgedPixels(measuring), seen_);
  if (const auto known = references_.find(count); known != references_.end()) return known->second;
  return references_
      .emplace(count,
               lightReferenceOf(*reference_, question_.volume, *hits_, count, pathsFor(noise_), progress))
      .first->second;
}

void LightEvaluator::draw(const scene::Scene& scene, base::Progress& progress) {
  drawn_.reset();
  render::FrameRequest whole{
      .size = question_.picture.size,
      .color = false,
      .aovs = {render::Aov::depth, render::Aov::irradiance},
      .supersampling = question_.picture.aovs.empty() ? scene.picture.supersampling : 1};
  base::Progress inner;  // a bake's own fraction is not the search's
  const std::stop_callback stop(progress.token(), [&inner] { inner.requestStop(); });
  lightPicture(controller_, renderer_, scene, whole, question_.volume, inner);
  if (whole.supersampling > 1) {  // which casts no ray through a pixel's centre, where light is judged
    whole.supersampling = 1;
    lightPicture(controller_, renderer_, scene, whole, question_.volume, inner);
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

LightErrors LightEvaluator::judge(const scene::Scene& scene, Measuring measuring, base::Progress& progress) {
  if (!reference_) {
    hits_ = &surface_.hitsOf(scene::Field::trilinear, progress);
    seen_ = static_cast<std::size_t>(std::count_if(hits_->begin(), hits_->end(), canBeJudged));
    reference_ = scene;
  }
  const LightReference& reference = referenceOf(measuring, progress);
  if (drawn_ != scene) draw(scene, progress);
  LightErrors errors = lightErrorsOf(irradiance_, reference);
  // Sampling without replacement: Cochran, Sampling Techniques (1977), eq. 2.20.
  const double part =
      std::min(1.0, static_cast<double>(judgedPixels(measuring)) / static_cast<double>(seen_));
  errors.rmseStandardError *= std::sqrt(1.0 - part);
  return errors;
}

}  // namespace isolux::app
