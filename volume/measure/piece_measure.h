// Area, volume and extent of each piece of the inside, with errors, and of all together.
#pragma once

#include <vector>

#include "volume/measure/surface_measure.h"
#include "volume/pieces/pieces.h"

namespace isolux::volume {

struct PieceMeasure {
  SurfaceMeasure surface;
  WorldBox bounds;  // of the piece, world mm
};

struct PieceMeasures {
  SurfaceMeasure whole;
  std::vector<PieceMeasure> pieces;  // in the order of Pieces::list(): the largest first
};

// `shown`: which pieces count for the whole, empty: all. `question`: its isovalue and inside are those of
// `pieces`; its box and keeps are not looked at. A cell that holds several pieces is cut into 4 x 4 x 4
// parts, each of one's own. Throws Error{interrupted}.
PieceMeasures measurePieces(const Pieces& pieces, const MinMaxBlocks& blocks, const SurfaceQuestion& question,
                            const std::vector<bool>& shown, base::Progress& progress);

}  // namespace isolux::volume
