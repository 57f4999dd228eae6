// The pieces of the inside by a flood from voxel to voxel: what fast code is judged by.
//
// Neighbours along an axis hang together; so do two corners of a cell that a path of samples on a fine
// lattice of the cell joins.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scene/choices.h"
#include "volume/grid.h"

namespace isolux::test {

struct FloodedPieces {
  std::vector<std::uint32_t> label;  // of each voxel, from 0; 0xffffffff outside
  std::vector<std::size_t> voxels;   // of each piece
};

// Which corners of a cell (x fastest) hang together where the trilinear interpolant is >= 0: of each the
// smallest one; 8 outside. By a flood over a lattice of samples. What it joins is joined, since samples that
// are neighbours have a straight line between them. A path inside has samples beside it that are at most 3/2
// of the steepest step lower; so what a flood at that much below 0 leaves apart is apart. Lattices become
// finer until both are the same, but no finer than 33^3.
struct FloodedCorners {
  std::array<int, 8> joined;    // for certain
  std::array<int, 8> possible;  // no others are joined
};
FloodedCorners floodedCorners(const std::array<double, 8>& values);

// joined <= the pieces of the trilinear interpolant <= possible.
struct FloodedBounds {
  FloodedPieces joined, possible;
};
FloodedBounds floodedPieces(const volume::Grid& grid, double isovalue, scene::Inside inside);

}  // namespace isolux::test
