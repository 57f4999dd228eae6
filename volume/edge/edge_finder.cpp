#include "volume/edge/edge_finder.h"

#include <algorithm>
#include <cmath>

#include "volume/field/noise_gain.h"
#include "volume/field/reconstruct.h"

namespace isolux::volume {

namespace {

constexpr double kSearchVoxels = 3.0, kSearchScales = 2.0;
constexpr double kRounding = 1e-12;             // of sums of samples, in parts of their size
constexpr double kBSplineVariance = 1.0 / 3.0;  // voxels^2, by which the cubic B-spline of samples smooths

glm::dmat3 diagonal(const glm::dvec3& v) {
  return {glm::dvec3(v.x, 0.0, 0.0), glm::dvec3(0.0, v.y, 0.0), glm::dvec3(0.0, 0.0, v.z)};
}

scene::Field splineOf(scene::Field field) {
  return field == scene::Field::trilinear ? scene::Field::cubic : field;
}

// By what the field smooths the samples, mm^2: a Gaussian, or along axes that are coarser the B-spline.
glm::dmat3 smoothingOf(const GridGeometry& geometry, scene::Field field, double scaleMm) {
  const glm::dvec3 least(field == scene::Field::cubic ? kBSplineVariance : 0.0);
  const glm::dvec3 deviations = deviationsInVoxels(geometry, scaleMm);
  const glm::dvec3 lacking = glm::max(least - deviations * deviations, glm::dvec3(0.0));
  const glm::dmat3 world(geometry.worldFromVoxel);
  return scaleMm * scaleMm * glm::dmat3(1.0) + world * diagonal(lacking) * glm::transpose(world);
}

}  // namespace

double automaticEdgeSearch(const GridGeometry& geometry, double scaleMm) {
  const glm::dvec3 spacing = geometry.spacingMm();
  return kSearchVoxels * std::max({spacing.x, spacing.y, spacing.z}) + kSearchScales * scaleMm;
}

EdgeSearch<double> edgeSearch(const Grid& grid, scene::Field field, double scaleMm,
                              const EdgeQuestion& question) {
  const GridGeometry& geometry = grid.geometry();
  const scene::Field spline = splineOf(field);
  EdgeSearch<double> search;
  // The spline of the samples bends round those that repeat beyond the border.
  for (int axis = 0; axis < 3; ++axis) {
    const double last = grid.dims()[axis] - 1, margin = scaleMm > 0.0 || last < 3.0 ? 0.0 : 1.0;
    search.low[axis] = margin;
    search.high[axis] = last - margin;
  }
  search.voxelFromWorld = glm::dmat3(geometry.voxelFromWorld());
  search.smoothing = smoothingOf(geometry, spline, scaleMm);
  const double stored = std::abs(grid.slope());
  const double largest = std::max(std::abs(grid.minimum()), std::abs(grid.maximum()));
  const double least = std::max(kLeastEdgeNoise * (grid.maximum() - grid.minimum()), kRounding * largest);
  const double noise = std::max(question.noise, least) / stored;
  const NoiseGain gain = noiseGain(spline, question.noiseBlur, deviationsInVoxels(geometry, scaleMm));
  if (noise > 0.0) search.unit = 1.0 / noise;
  search.noise = glm::transpose(search.voxelFromWorld) * diagonal(gain.gradient) * search.voxelFromWorld;
  search.outward = grid.slope() < 0.0 ? -question.outward : question.outward;
  search.searchMm = question.searchMm;
  search.contrast = question.contrast;
  search.leastStepMm = 0.5 * scaleMm;
  return search;
}

EdgeSearch<float> inFloats(const EdgeSearch<double>& search) {
  return {glm::vec3(search.low),
          glm::vec3(search.high),
          glm::mat3(search.voxelFromWorld),
          glm::mat3(search.smoothing),
          glm::mat3(search.noise),
          static_cast<float>(search.unit),
          static_cast<float>(search.outward),
          static_cast<float>(search.searchMm),
          static_cast<float>(search.contrast),
          static_cast<float>(search.leastStepMm)};
}

EdgeFinder::EdgeFinder(const Grid& grid, const EdgeField& field, const EdgeQuestion& question)
    : EdgeFinder(grid, field,
                 edgeSearch(grid, field.field, field.scaled ? field.scaled->scaleMm : 0.0, question)) {}

Edge EdgeFinder::at(const glm::dvec3& voxel) const {
  const double slope = grid_.slope();
  const auto sample = [&](const glm::dvec3& p) {
    if (grid_.missingCount() > 0 && grid_.cellHasMissing(grid_.geometry().cellOf(p)))
      return EdgeSample<double>{};
    const FieldSample field = field_.scaled         ? sampleScaled(*field_.scaled, grid_, p)
                              : field_.coefficients ? sampleCubic(*field_.coefficients, grid_, p)
                                                    : sampleCubic(grid_, p);
    const double unit = search_.unit / slope;
    return EdgeSample<double>{field.gradient * unit, field.hessian * unit, !std::isnan(field.value)};
  };
  const FoundEdge<double> found = findEdge(search_, sample, voxel);
  return {found.found ? std::optional(found.offsetMm) : std::nullopt, found.strength};
}

}  // namespace isolux::volume
