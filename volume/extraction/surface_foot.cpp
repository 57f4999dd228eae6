#include "volume/extraction/surface_foot.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "volume/field/reconstruct.h"

namespace isolux::volume {

SurfaceFoot::SurfaceFoot(const Grid& grid, scene::Field field, const Coefficients* coefficients,
                         double isovalue)
    : grid_(grid), field_(field), coefficients_(coefficients), isovalue_(isovalue) {
  const glm::dmat3 inverse = glm::inverse(glm::dmat3(grid.geometry().worldFromVoxel));
  metric_ = inverse * glm::transpose(inverse);
}

SurfaceFoot::Sample SurfaceFoot::at(const glm::dvec3& voxel) const {
  const FieldSample s = field_ == scene::Field::trilinear ? sampleTrilinear(grid_, voxel)
                        : coefficients_ != nullptr        ? sampleCubic(*coefficients_, grid_, voxel)
                                                          : sampleCubic(grid_, voxel);
  return {s.value - isovalue_, s.gradient};
}

std::optional<glm::dvec3> SurfaceFoot::of(const glm::dvec3& voxel) const {
  constexpr int steps = 24;
  constexpr double near = 1e-9, farthest = 2.0, longest = 0.5;  // voxels
  const glm::dvec3 last(grid_.dims() - 1);
  glm::dvec3 point = voxel;
  for (int i = 0; i < steps; ++i) {
    const Sample sample = at(point);
    const glm::dvec3 across = metric_ * sample.gradient;
    const double slope = glm::dot(sample.gradient, across);
    if (!(slope > 0.0)) return std::nullopt;  // NaN too
    glm::dvec3 step = -sample.off / slope * across;
    if (const double length = glm::length(step); length > longest) step *= longest / length;
    point = glm::clamp(point + step, glm::dvec3(0.0), last);
    if (glm::distance(point, voxel) > farthest) return std::nullopt;
    if (glm::length(step) < near) return point;
  }
  return std::nullopt;
}

}  // namespace isolux::volume
