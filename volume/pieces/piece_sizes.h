// How large pieces are: their voxels, and estimates of their volumes that cost little enough to be made at
// every isovalue.
#pragma once

#include <vector>

#include "base/progress.h"
#include "volume/pieces/cell_volumes.h"
#include "volume/pieces/pieces.h"

namespace isolux::volume {

// One for each of `count` pieces, which pieces.ofLabel() tells. `volumes`: of joinBlocks(). Multithreaded;
// the same whatever the threads.
std::vector<Piece> pieceSizes(const Pieces& pieces, std::size_t count, const NodeVolumes& volumes,
                              base::Progress& progress);

}  // namespace isolux::volume
