#include "app/target/light_judge.h"

#include <cmath>
#include <limits>
#include <stop_token>

#include "app/light/light_picture.h"
#include "app/study/light_truth.h"
#include "base/progress.h"
#include "gi/light_scene.h"

namespace isolux::app {

LightJudge::LightJudge(render::Renderer& renderer, SurfaceTruth& truth,
                       std::shared_ptr<const volume::PreparedVolume> volume, const scene::Machine& machine,
                       glm::ivec2 size)
    : renderer_(renderer),
      surface_(truth),
      volume_(std::move(volume)),
      size_(size),
      controller_({.threads = machine.threads}) {}

// Light that stands still, whatever is stored of it.
void LightJudge::trace(const scene::Scene& scene, base::Progress& progress) {
  hits_ = surface_.of(scene::Field::trilinear, scene::Field::cubic, progress).hits;
  scene::Scene still = scene;
  still.gi.mode = scene::GiMode::irradiance;
  still.light.environment.moves = false;
  still.gi.sequence = scene::DirectionSequence::sobol_owen;
  const auto environment = gi::loadEnvironment(still.light.environment);
  const auto light =
      gi::makeLightScene(still, volume_, gi::lightTracerOf(still, volume_, progress), environment);
  const double exposure = std::exp2(still.light.environment.exposure);
  const glm::dvec3 skyScale = light->choice.unitSky ? exposure * environment->mean() : glm::dvec3(exposure);
  std::vector<bool> isHit;
  isHit.reserve(hits_.size());
  for (const TrueHit& hit : hits_) isHit.push_back(hit.hit && hit.fromOutside);
  const std::vector<std::size_t> pixels = chosenPixels(isHit, kJudgedPixels);
  std::vector<glm::vec3> voxels;
  voxels.reserve(pixels.size());
  for (const std::size_t pixel : pixels) voxels.emplace_back(hits_[pixel].voxel);
  const auto isovalue = static_cast<float>(volume_->grid().storedOfValue(still.isosurface.value.value()));
  truth_ = lightTruthAt(light, skyScale, isovalue, voxels, pixels, {}, progress);
}

LightErrors LightJudge::judge(const scene::Scene& scene, base::Progress& progress) {
  if (hits_.empty()) trace(scene, progress);
  render::FrameRequest request;
  request.size = size_;
  request.color = false;
  request.aovs = {render::Aov::depth, render::Aov::irradiance};
  base::Progress inner;  // a bake's own fraction is not the search's
  const std::stop_callback stop(progress.token(), [&inner] { inner.requestStop(); });
  lightPicture(controller_, renderer_, scene, request, volume_, inner);
  renderer_.render(litScene(scene, request), request);
  const std::vector<float> depthMm = renderer_.readAov(render::Aov::depth).values;
  std::vector<float> irradiance = renderer_.readAov(render::Aov::irradiance).values;
  for (std::size_t i = 0; i < hits_.size(); ++i)
    if (!hits_[i].hit || !isFirstCrossing(static_cast<double>(depthMm[i]), hits_[i]))
      irradiance[3 * i] = std::numeric_limits<float>::quiet_NaN();
  return lightErrorsOf(irradiance, truth_);
}

}  // namespace isolux::app
