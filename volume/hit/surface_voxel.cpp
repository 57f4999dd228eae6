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
  const auto depthAt = [&](glm::ivec3 at) { return level.depth(grid.stored(at)); };
  CellCorners depths;
  for (std::size_t i = 0; i < 8; ++i) depths[i] = depthAt(grid.extent().corner(cell, i));
  const int above = cornerAbove(depths, local);
  if (depths[static_cast<std::size_t>(above)] >= 0.0) return grid.extent().corner(cell, above);
  std::optional<glm::ivec3> nearest;
  double least = std::numeric_limits<double>::infinity();
  const glm::ivec3 low = glm::max(cell - 1, glm::ivec3(0)), high = glm::min(cell + 2, grid.dims() - 1);
  forEachIn(low, high + 1, [&](glm::ivec3 at) {
    const glm::dvec3 apart = glm::dvec3(at - cell) - local;
    const double squared = glm::dot(apart, apart);
    if (squared >= least - kAsNear || !(depthAt(at) >= 0.0)) return;
    least = squared;
    nearest = at;
  });
  return nearest;
}

std::optional<glm::ivec3> surfaceVoxel(const Grid& grid, InsideLevel level, const glm::dvec3& voxel) {
  const glm::ivec3 cell = grid.geometry().cellOf(voxel);
  return surfaceVoxel(grid, level, cell, glm::clamp(voxel - glm::dvec3(cell), 0.0, 1.0));
}

}  // namespace isolux::volume
