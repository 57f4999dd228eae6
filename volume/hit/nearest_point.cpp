#include "volume/hit/nearest_point.h"

#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "volume/field/reconstruct.h"
#include "volume/hit/shown_cells.h"

namespace isolux::volume {

namespace {

constexpr int kSlides = 3;            // along the surface
constexpr int kCorrections = 2;       // Newton's, back to it, after each
constexpr double kOffSurface = 1e-3;  // voxels: farther off is no point of the surface

float distanceSquared(glm::vec3 a, glm::vec3 b) {
  return glm::dot(a - b, a - b);
}

// Where the surface crosses an edge of the cells that reach touches, nearest to `voxel`.
std::optional<glm::vec3> nearestEdgeCrossing(const Grid& grid, glm::vec3 voxel, glm::vec3 reach,
                                             float isovalue, const VoxelMask* hidden) {
  const glm::ivec3 last = grid.dims() - 1;
  const glm::ivec3 low = glm::clamp(glm::ivec3(glm::floor(voxel - reach)), glm::ivec3(0), last);
  const glm::ivec3 high = glm::clamp(glm::ivec3(glm::ceil(voxel + reach)), glm::ivec3(0), last);
  std::optional<glm::vec3> nearest;
  float least = std::numeric_limits<float>::infinity();
  forEachIn(low, high + 1, [&](glm::ivec3 at) {
    const float here = static_cast<float>(grid.stored(at)) - isovalue;
    for (int axis = 0; axis < 3; ++axis) {
      if (at[axis] == high[axis]) continue;
      glm::ivec3 next = at;
      ++next[axis];
      const float there = static_cast<float>(grid.stored(next)) - isovalue;
      const bool crossed = (here >= 0.0f && there < 0.0f) || (here < 0.0f && there >= 0.0f);
      if (!crossed || (hidden && (hidden->at(at) || hidden->at(next)))) continue;
      glm::vec3 point(at);
      point[axis] += here / (here - there);
      const float squared = distanceSquared(point, voxel);
      if (squared >= least) continue;
      least = squared;
      nearest = point;
    }
  });
  return nearest;
}

// Back to the surface along the gradient; nothing where that does not lead there. isovalue: data units.
std::optional<glm::vec3> ontoSurface(const Grid& grid, glm::dvec3 point, double isovalue) {
  for (int i = 0;; ++i) {
    point = glm::clamp(point, glm::dvec3(0.0), glm::dvec3(grid.dims() - 1));
    const FieldSample field = sampleTrilinear(grid, point);
    const double off = field.value - isovalue, squared = glm::dot(field.gradient, field.gradient);
    if (!(squared > 0.0)) return std::nullopt;  // NaN too
    if (i == kCorrections) {
      if (off * off > kOffSurface * kOffSurface * squared) return std::nullopt;
      return glm::vec3(point);
    }
    point -= field.gradient * (off / squared);
  }
}

}  // namespace

std::optional<glm::vec3> nearestSurfacePoint(const Grid& grid, glm::vec3 voxel, glm::vec3 reach,
                                             float isovalue, const HiddenPieces& hidden) {
  const std::optional<glm::vec3> start = nearestEdgeCrossing(grid, voxel, reach, isovalue, hidden.voxels);
  if (!start) return std::nullopt;
  const double value = grid.valueOfStored(static_cast<double>(isovalue));
  const ShownCells shown(grid, hidden.voxels, value, hidden.inside);
  const glm::dvec3 from(voxel);
  glm::vec3 nearest = *start;
  for (int i = 0; i < kSlides; ++i) {
    const glm::dvec3 at(nearest), gradient = sampleTrilinear(grid, at).gradient;
    const double squared = glm::dot(gradient, gradient);
    if (!(squared > 0.0)) break;  // NaN too
    // The foot of the perpendicular on the tangent plane.
    const glm::dvec3 foot = from + gradient * (glm::dot(at - from, gradient) / squared);
    const std::optional<glm::vec3> closer = ontoSurface(grid, foot, value);
    if (hidden.voxels && closer && shown.hiddenAt(*closer)) break;
    if (!closer || distanceSquared(*closer, voxel) >= distanceSquared(nearest, voxel)) break;
    nearest = *closer;
  }
  return nearest;
}

}  // namespace isolux::volume
