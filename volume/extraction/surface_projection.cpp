#include "volume/extraction/surface_projection.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "volume/field/reconstruct.h"

namespace isolux::volume {

SurfaceProjection::SurfaceProjection(const Grid& grid, scene::Field field, const Coefficients* coefficients,
                                     double isovalue)
    : grid_(grid), field_(field), coefficients_(coefficients), isovalue_(isovalue) {
  const glm::dmat3 inverse = glm::inverse(glm::dmat3(grid.geometry().worldFromVoxel));
  metric_ = inverse * glm::transpose(inverse);
}

std::optional<glm::dvec3> SurfaceProjection::of(const glm::dvec3& voxel) const {
  constexpr int steps = 24;
  constexpr double near = 1e-9, farthest = 2.0, longest = 0.5;  // voxels
  const glm::dvec3 last(grid_.dims() - 1);
  glm::dvec3 point = voxel;
  for (int i = 0; i < steps; ++i) {
    const FieldSample sample = sampleField(grid_, field_, coefficients_, point);
    const glm::dvec3 across = metric_ * sample.gradient;
    const double slope = glm::dot(sample.gradient, across);
    if (!(slope > 0.0)) return std::nullopt;  // NaN too
    glm::dvec3 step = (isovalue_ - sample.value) / slope * across;
    if (const double length = glm::length(step); length > longest) step *= longest / length;
    point = glm::clamp(point + step, glm::dvec3(0.0), last);
    if (glm::distance(point, voxel) > farthest) return std::nullopt;
    if (glm::length(step) < near) return point;
  }
  return std::nullopt;
}

}  // namespace isolux::volume
