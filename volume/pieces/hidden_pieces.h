// What of an isosurface is hidden, as those who find its points are told.
#pragma once

#include "scene/choices.h"
#include "volume/pieces/hidden_voxels.h"

namespace isolux::volume {

struct HiddenPieces {
  const HiddenVoxels* voxels = nullptr;  // null: all is shown
  scene::Inside inside = scene::Inside::above;
};

}  // namespace isolux::volume
