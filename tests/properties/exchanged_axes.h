// A grid whose axes are exchanged and mirrored, and where its voxels have gone.
#pragma once

#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

#include "volume/grid.h"

namespace isolux::test {

// New axis a is old axis from[a], the other way round where mirrored.
struct AxisExchange {
  std::array<int, 3> from{0, 1, 2};
  std::array<bool, 3> mirrored{false, false, false};

  glm::dvec3 point(const glm::dvec3& old, glm::ivec3 oldDims) const;
  glm::dvec3 direction(const glm::dvec3& old) const;
  glm::dvec3 pointBefore(const glm::dvec3& made, glm::ivec3 oldDims) const;  // the inverse of point()
};

AxisExchange exchangeOf(std::uint64_t seed);
// With voxels of 1 mm, the first at the world's origin.
volume::Grid exchanged(const volume::Grid& grid, const AxisExchange& exchange);

}  // namespace isolux::test
