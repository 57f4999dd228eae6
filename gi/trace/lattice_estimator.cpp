#include "gi/trace/lattice_estimator.h"

#include <cmath>

#include "base/random.h"
#include "gi/trace/path_wave.h"
#include "volume/hit/nearest_point.h"

namespace isolux::gi {

namespace {

// The trilinear field at a position inside the domain, stored units; NaN where a voxel that it is made of is
// missing.
float fieldAt(const volume::Grid& grid, glm::vec3 voxel) {
  const glm::ivec3 last = grid.dims() - 1;
  const glm::ivec3 low = glm::clamp(glm::ivec3(glm::floor(voxel)), glm::ivec3(0), last);
  const glm::ivec3 high = glm::min(low + 1, last);
  const glm::dvec3 part = glm::clamp(glm::dvec3(voxel) - glm::dvec3(low), 0.0, 1.0);
  double value = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::bvec3 isHigh(volume::cornerStep(corner));
    const glm::dvec3 weights = glm::mix(1.0 - part, part, isHigh);
    const double weight = weights.x * weights.y * weights.z;
    // What has no weight may be missing.
    if (weight > 0.0) value += weight * grid.stored(glm::mix(low, high, isHigh));
  }
  return static_cast<float>(value);
}

// Texels that are lit each on its own isosurface know no pieces.
std::shared_ptr<const LightScene> lightOf(std::shared_ptr<const LightScene> light,
                                          const LatticeGeometry& geometry) {
  if (geometry.isovalue || !light->tracer || light->tracer->hidden().empty()) return light;
  auto whole = std::make_shared<LightScene>(*light);
  whole->tracer = light->tracer->withAllPieces();
  return whole;
}

}  // namespace

LatticeEstimator::LatticeEstimator(std::shared_ptr<const LightScene> light, const LatticeGeometry& geometry,
                                   LightPart part)
    : tracer_(lightOf(std::move(light), geometry)), geometry_(geometry), part_(part) {}

LightContent LatticeEstimator::content() const {
  const LightScene& light = tracer_.light();
  if (part_ == LightPart::lamps) return {LightContent::Kind::irradiance, 3, 0};
  if (light.choice.sky == scene::GiMode::transfer)
    return {LightContent::Kind::transfer, light.choice.channels, light.shOrder};
  return {LightContent::Kind::irradiance, light.choice.channels, 0};
}

void LatticeEstimator::points(std::span<const glm::ivec3> texels, std::span<TexelPoint> points) const {
  const volume::Grid& grid = tracer_.light().volume->grid();
  std::vector<glm::vec3> voxels(texels.size()), gradients(texels.size());
  std::vector<bool> has(texels.size());
  const std::vector<volume::HiddenOfSurface> surfaces = tracer_.light().tracer->hidden();
  volume::HiddenPieces hidden;
  if (geometry_.isovalue) hidden = volume::hiddenAt(surfaces, grid, *geometry_.isovalue);
  for (std::size_t i = 0; i < texels.size(); ++i) {
    std::optional<glm::vec3> place = geometry_.voxelOf(texels[i]);
    if (geometry_.isovalue)
      place = volume::nearestSurfacePoint(grid, *place, geometry_.reach(), *geometry_.isovalue, hidden);
    if (place) voxels[i] = *place;
    has[i] = place && !std::isnan(fieldAt(grid, *place));
  }
  tracer_.light().tracer->gradients(voxels, gradients);
  for (std::size_t i = 0; i < texels.size(); ++i)
    points[i] = {voxels[i], has[i] ? tracer_.normalOf(gradients[i]) : glm::vec3(0.0f)};
}

bool LatticeEstimator::add(std::span<const glm::ivec3> texels, std::span<const TexelPoint> at,
                           SampleRange range, std::span<double> sums, std::uint64_t& rays,
                           const std::stop_token& stop) const {
  const volume::Grid& grid = tracer_.light().volume->grid();
  std::vector<LightPoint> points(texels.size());
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const float isovalue = geometry_.isovalue ? *geometry_.isovalue : fieldAt(grid, at[i].voxel);
    points[i] = {at[i].voxel, isovalue, at[i].normal, base::hash32(geometry_.indexOf(texels[i]))};
  }
  const LightContent content = this->content();
  if (content.kind == LightContent::Kind::transfer)
    return tracer_.addTransfer(points, range, sums, rays, stop);
  return tracer_.addIrradiance(part_, points, range, content.channels, sums, rays, stop);
}

}  // namespace isolux::gi
