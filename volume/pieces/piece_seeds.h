// Voxels that name pieces: where the field is deepest inside, so that they stay inside the longest when the
// isovalue moves inward.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "volume/pieces/pieces.h"

namespace isolux::volume {

// The deepest voxel of each piece; of equal ones the first in memory. Multithreaded; throws
// Error{interrupted}.
std::vector<glm::ivec3> pieceSeeds(const Pieces& pieces, base::Progress& progress);

// From a voxel inside, again and again to the deepest of its six neighbours, until none is deeper: of the
// same piece. From where somebody points this is nearer than the piece's deepest voxel, and where a larger
// isovalue breaks the piece, it is in the part that was pointed at.
glm::ivec3 seedAbove(const Grid& grid, InsideLevel level, glm::ivec3 voxel);

}  // namespace isolux::volume
