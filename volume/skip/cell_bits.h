// Which cells an isosurface can cross, a bit each: the third level below MinMaxBlocks and BoxBounds, made
// from the voxels for the isovalues that are shown.
//
// A cell whose bit is 0 has all its corners on one side of each isovalue, by more than floats can lose when
// they interpolate: rays that leave it out find the same crossings. Volumes with missing voxels have no such
// bits, since a cell with a missing corner is on no side.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "volume/grid.h"

namespace isolux::volume {

// Of each group of 4x4x4 cells (x fastest, two per axis and block of 8x8x8) a mask: bit x + 4 y + 16 z is
// set where that cell can hold a crossing of one of the isovalues (stored units). boxMasks: of each block,
// 0 where none can (BoxBounds::masks). Multithreaded; time goes with the voxels of blocks that are not 0.
void cellBits(const Grid& grid, glm::ivec3 blocks, std::span<const std::uint64_t> boxMasks,
              std::span<const float> storedIsovalues, std::vector<std::uint64_t>& result);

}  // namespace isolux::volume
