// What of an isosurface is hidden, as those are told who find its points or trace its light.
#pragma once

#include <memory>

#include "scene/choices.h"
#include "volume/pieces/hidden_voxels.h"

namespace isolux::volume {

struct HiddenPieces {
  const HiddenVoxels* voxels = nullptr;  // null: all is shown
  scene::Inside inside = scene::Inside::above;
};

// The same of one of several isosurfaces, kept.
struct HiddenOfSurface {
  double isovalue = 0.0;  // data units
  std::shared_ptr<const HiddenVoxels> voxels;
  scene::Inside inside = scene::Inside::above;
};

}  // namespace isolux::volume
