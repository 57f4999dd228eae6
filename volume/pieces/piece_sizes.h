// How large pieces are: their voxels, and their volumes with a bound, from every crossed cell.
#pragma once

#include <array>
#include <vector>

#include "base/progress.h"
#include "volume/pieces/pieces.h"

namespace isolux::volume {

// The part of a cell in which f >= 0: within `error` of `part`, from 1 / 16 of the cell's columns at a time.
// Along a column f is linear from its value a to its value b, and the length inside grows with both; so it
// lies between those of the column's least a and b and of its greatest.
struct CellPart {
  float part, error;
};
CellPart partInside(const std::array<float, 8>& depths);

// One for each of `count` pieces, which pieces.ofNode() tells. Multithreaded; the same whatever the threads.
std::vector<Piece> pieceSizes(const Pieces& pieces, std::size_t count, base::Progress& progress);

}  // namespace isolux::volume
