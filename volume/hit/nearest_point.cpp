#include "volume/hit/nearest_point.h"

#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace isolux::volume {

namespace {

constexpr int kSlides = 3;            // along the surface
constexpr int kCorrections = 2;       // Newton's, back to it, after each
constexpr float kOffSurface = 1e-3f;  // voxels: farther off is no point of the surface

float distanceSquared(glm::vec3 a, glm::vec3 b) {
  return glm::dot(a - b, a - b);
}

// The field and its gradient in one cell, voxel coordinates.
struct CellField {
  float value = 0.0f;
  glm::vec3 gradient{0.0f};
};

CellField cellFieldAt(const Grid& grid, glm::vec3 voxel) {
  const glm::ivec3 last = glm::max(grid.dims() - 2, glm::ivec3(0));
  const glm::ivec3 low = glm::clamp(glm::ivec3(glm::floor(voxel)), glm::ivec3(0), last);
  const glm::ivec3 high = glm::min(low + 1, grid.dims() - 1);
  const glm::vec3 part = voxel - glm::vec3(low);
  float corners[8];
  for (int i = 0; i < 8; ++i)
    corners[i] = static_cast<float>(
        grid.stored((i & 1) ? high.x : low.x, (i & 2) ? high.y : low.y, (i & 4) ? high.z : low.z));
  const auto mixed = [](float a, float b, float t) { return a + t * (b - a); };
  float alongX[4], slopeX[4];
  for (int i = 0; i < 4; ++i) {
    alongX[i] = mixed(corners[2 * i], corners[2 * i + 1], part.x);
    slopeX[i] = corners[2 * i + 1] - corners[2 * i];
  }
  const float y0 = mixed(alongX[0], alongX[1], part.y), y1 = mixed(alongX[2], alongX[3], part.y);
  CellField field;
  field.value = mixed(y0, y1, part.z);
  field.gradient.x = mixed(mixed(slopeX[0], slopeX[1], part.y), mixed(slopeX[2], slopeX[3], part.y), part.z);
  field.gradient.y = mixed(alongX[1] - alongX[0], alongX[3] - alongX[2], part.z);
  field.gradient.z = y1 - y0;
  return field;
}

// Where the surface crosses an edge of the cells that reach touches, nearest to `voxel`.
std::optional<glm::vec3> nearestEdgeCrossing(const Grid& grid, glm::vec3 voxel, glm::vec3 reach,
                                             float isovalue) {
  const glm::ivec3 last = grid.dims() - 1;
  const glm::ivec3 low = glm::clamp(glm::ivec3(glm::floor(voxel - reach)), glm::ivec3(0), last);
  const glm::ivec3 high = glm::clamp(glm::ivec3(glm::ceil(voxel + reach)), glm::ivec3(0), last);
  std::optional<glm::vec3> nearest;
  float least = std::numeric_limits<float>::infinity();
  for (int z = low.z; z <= high.z; ++z)
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) {
        const glm::ivec3 at(x, y, z);
        const float here = static_cast<float>(grid.stored(x, y, z)) - isovalue;
        for (int axis = 0; axis < 3; ++axis) {
          if (at[axis] == high[axis]) continue;
          glm::ivec3 next = at;
          ++next[axis];
          const float there = static_cast<float>(grid.stored(next.x, next.y, next.z)) - isovalue;
          const bool crossed = (here >= 0.0f && there < 0.0f) || (here < 0.0f && there >= 0.0f);
          if (!crossed) continue;
          glm::vec3 point(at);
          point[axis] += here / (here - there);
          const float squared = distanceSquared(point, voxel);
          if (squared >= least) continue;
          least = squared;
          nearest = point;
        }
      }
  return nearest;
}

// Back to the surface along the gradient; nothing where that does not lead there.
std::optional<glm::vec3> ontoSurface(const Grid& grid, glm::vec3 point, float isovalue) {
  for (int i = 0;; ++i) {
    point = glm::clamp(point, glm::vec3(0.0f), glm::vec3(grid.dims() - 1));
    const CellField field = cellFieldAt(grid, point);
    const float off = field.value - isovalue, squared = glm::dot(field.gradient, field.gradient);
    if (!(squared > 0.0f)) return std::nullopt;  // NaN too
    if (i == kCorrections) {
      if (off * off > kOffSurface * kOffSurface * squared) return std::nullopt;
      return point;
    }
    point -= field.gradient * (off / squared);
  }
}

}  // namespace

std::optional<glm::vec3> nearestSurfacePoint(const Grid& grid, glm::vec3 voxel, glm::vec3 reach,
                                             float isovalue) {
  const std::optional<glm::vec3> start = nearestEdgeCrossing(grid, voxel, reach, isovalue);
  if (!start) return std::nullopt;
  glm::vec3 nearest = *start;
  for (int i = 0; i < kSlides; ++i) {
    const glm::vec3 gradient = cellFieldAt(grid, nearest).gradient;
    const float squared = glm::dot(gradient, gradient);
    if (!(squared > 0.0f)) break;
    // The foot of the perpendicular on the tangent plane.
    const glm::vec3 foot = voxel + gradient * (glm::dot(nearest - voxel, gradient) / squared);
    const std::optional<glm::vec3> closer = ontoSurface(grid, foot, isovalue);
    if (!closer || distanceSquared(*closer, voxel) >= distanceSquared(nearest, voxel)) break;
    nearest = *closer;
  }
  return nearest;
}

}  // namespace isolux::volume
