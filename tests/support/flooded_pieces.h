// The pieces of the inside by a flood from voxel to voxel: what fast code is judged by.
//
// Neighbours along an axis hang together; so do two corners of a cell that a path of samples on a fine
// lattice of the cell joins. The lattice decides by values a little above and below: where both say
// otherwise, the cell counts as undecided.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scene/choices.h"
#include "volume/grid.h"

namespace isolux::test {

struct FloodedPieces {
  std::vector<std::uint32_t> label;  // of each voxel, from 0 in the order of memory; 0xffffffff outside
  std::vector<std::size_t> voxels;   // of each piece
  std::size_t undecidedCells = 0;
};

// `inCells`: also through cells, not along axes alone.
FloodedPieces floodedPieces(const volume::Grid& grid, double isovalue, scene::Inside inside, bool inCells);

// Which corners of a cell (x fastest) are joined by a lattice of n^3 samples at which the trilinear
// interpolant is >= level: of each the smallest one; 8 outside.
std::array<int, 8> floodedCorners(const std::array<double, 8>& values, int n, double level);

}  // namespace isolux::test
