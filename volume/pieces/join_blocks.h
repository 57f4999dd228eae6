// Joins the components of blocks to pieces: across the faces of blocks, and inside the cells whose inside
// corners do not hang together along edges.
#pragma once

#include "base/progress.h"
#include "volume/pieces/concurrent_sets.h"
#include "volume/pieces/piece_blocks.h"

namespace isolux::volume {

// `sets`: of blocks.nodes(). Multithreaded; throws Error{interrupted}.
void joinBlocks(const Grid& grid, const PieceBlocks& blocks, InsideLevel level, ConcurrentSets& sets,
                base::Progress& progress);

}  // namespace isolux::volume
