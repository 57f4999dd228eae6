// Which pieces of an isosurface are shown, and the voxels of those that are not.
#pragma once

#include <memory>
#include <vector>

#include "scene/scene.h"
#include "volume/pieces/body.h"
#include "volume/pieces/pieces.h"
#include "volume/visible/voxel_mask.h"

namespace isolux::volume {

// Whether the choice can hide anything: where not, nobody need know the pieces.
bool hidesPieces(const scene::Pieces& choice);

// Of each piece whether it is shown. All conditions hold at once; pieces.keep counts among all pieces, not
// among those that the others leave. A point outside of all pieces names none. `body`: the one above
// choice.within, where that is given (PieceSets::shown() has it).
std::vector<bool> shownPieces(const Pieces& pieces, const scene::Pieces& choice, const Body* body = nullptr);

// Whether the choice names what is shown, so that what belongs to no piece is hidden; else it names what is
// hidden.
bool hidesStrays(const scene::Pieces& choice);

// The voxels of pieces that are not shown. Multithreaded.
VoxelMask hiddenVoxels(const Pieces& pieces, const std::vector<bool>& shown, bool hidesStrays);

}  // namespace isolux::volume
