// How large pieces are: their voxels, and estimates of their volumes that cost little enough to be made at
// every isovalue.
#pragma once

#include <array>
#include <vector>

#include "base/progress.h"
#include "volume/hit/bernstein_cubic.h"
#include "volume/pieces/pieces.h"

namespace isolux::volume {

// The part of a cell in which f >= 0: the mean of 4 x 4 columns along x, along which f is linear. Exact where
// every column is crossed and the length inside changes linearly from one to the next.
float partInside(const std::array<float, 8>& depths);

// The same in parts, each of the piece of a corner: what the columns hold that lead to it (cornerAbove).
std::array<double, 8> cornerShares(const CellCorners& values);

// One for each of `count` pieces, which pieces.ofNode() tells. Multithreaded; the same whatever the threads.
std::vector<Piece> pieceSizes(const Pieces& pieces, std::size_t count, base::Progress& progress);

}  // namespace isolux::volume
