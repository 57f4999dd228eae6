// What of an isosurface is hidden, as those are told who find its points or trace its light.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "scene/scene.h"
#include "volume/visible/voxel_mask.h"

namespace isolux::volume {

class Grid;

struct HiddenPieces {
  const VoxelMask* voxels = nullptr;  // null: all is shown
  scene::Inside inside = scene::Inside::above;
};

// The same of one of several isosurfaces, kept.
struct HiddenOfSurface {
  double isovalue = 0.0;  // data units
  std::shared_ptr<const VoxelMask> voxels;
  scene::Inside inside = scene::Inside::above;
};
HiddenPieces hiddenAt(std::span<const HiddenOfSurface> surfaces, double isovalue);
// The same by the stored isovalue that rays compare with.
HiddenPieces hiddenAt(std::span<const HiddenOfSurface> surfaces, const Grid& grid, float storedIsovalue);
// Equal where the same is hidden; 0 where nothing is.
std::uint64_t keyOf(std::span<const HiddenOfSurface> surfaces);

}  // namespace isolux::volume
