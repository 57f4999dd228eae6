#include "volume/hit/surface_voxel.h"

#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "volume/hit/cell_pieces.h"

namespace isolux::volume {

namespace {
// Square of voxels. Stretches through whole cells have their middles just as far from the samples on both
// sides: of samples as near as that the first counts, whatever rounding makes of them.
constexpr double kAsNear = 1e-4;
}  // namespace

std::optional<glm::ivec3> surfaceVoxel(const Grid& grid, InsideLevel level, glm::ivec3 cell,
                                       const glm::dvec3& local) {
  const auto depthAt = [&](glm::ivec3 at) { return level.depth(grid.stored(at.x, at.y, at.z)); };
  CellCorners depths;
  const auto corner = [&](int i) {
    return glm::min(cell + glm::ivec3(i & 1, i >> 1 & 1, i >> 2), grid.dims() - 1);
  };
  for (int i = 0; i < 8; ++i) depths[static_cast<std::size_t>(i)] = depthAt(corner(i));
  const int above = cornerAbove(depths, local);
  if (depths[static_cast<std::size_t>(above)] >= 0.0) return corner(above);
  std::optional<glm::ivec3> nearest;
  double least = std::numeric_limits<double>::infinity();
  const glm::ivec3 low = glm::max(cell - 1, glm::ivec3(0)), high = glm::min(cell + 2, grid.dims() - 1);
  for (int z = low.z; z <= high.z; ++z)
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) {
        const glm::ivec3 at(x, y, z);
        const glm::dvec3 apart = glm::dvec3(at - cell) - local;
        const double squared = glm::dot(apart, apart);
        if (squared >= least - kAsNear || !(depthAt(at) >= 0.0)) continue;
        least = squared;
        nearest = at;
      }
  return nearest;
}

std::optional<glm::ivec3> surfaceVoxel(const Grid& grid, InsideLevel level, const glm::dvec3& voxel) {
  const glm::ivec3 cell =
      glm::clamp(glm::ivec3(glm::floor(voxel)), glm::ivec3(0), glm::max(grid.dims() - 2, glm::ivec3(0)));
  return surfaceVoxel(grid, level, cell, glm::clamp(voxel - glm::dvec3(cell), 0.0, 1.0));
}

}  // namespace isolux::volume
