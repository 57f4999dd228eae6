// Joins the components of blocks to pieces: across the faces of blocks, and inside the cells whose inside
// corners do not hang together along edges; and adds up what the cells enclose, which are looked at once for
// both.
#pragma once

#include "base/progress.h"
#include "volume/pieces/cell_volumes.h"
#include "volume/pieces/concurrent_union_find.h"
#include "volume/pieces/piece_blocks.h"

namespace isolux::volume {

// `sets`: of blocks.nodes(). Returns the volume of each node, 0 where the grid has none. Multithreaded;
// throws Error: interrupted, memory.
NodeVolumes joinBlocks(const Grid& grid, const PieceBlocks& blocks, InsideLevel level,
                       ConcurrentUnionFind& sets, base::Progress& progress);

}  // namespace isolux::volume
