// Which boxes and cells hold anything of an isosurface that is seen: those with an inside voxel that is of no
// hidden piece.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "volume/grid.h"
#include "volume/skip/box_bounds.h"
#include "volume/visible/inside_level.h"
#include "volume/visible/voxel_mask.h"

namespace isolux::volume {

struct PartlyShown {
  float isovalue;           // as the field's blocks hold it
  const VoxelMask* hidden;  // null: all is shown
  InsideLevel level;        // of the voxels
};

// BoxBounds::masks() without the boxes that hold nothing that is seen. cubic: of a field that looks up one
// voxel more on each side; there, boxes without inside voxels stay where nothing around is hidden, since
// splines may overshoot; rays decide about strays (ShownCells). Multithreaded.
void shownBoxes(const Grid& grid, const BoxBounds& boxes, std::span<const PartlyShown> surfaces, bool cubic,
                const std::vector<std::uint8_t>& flags, std::vector<std::uint64_t>& masks);
// The same of cellBits(), of the trilinear field; boxMasks: those of shownBoxes().
void shownCellBits(const Grid& grid, glm::ivec3 blocks, std::span<const std::uint64_t> boxMasks,
                   std::span<const PartlyShown> surfaces, std::vector<std::uint64_t>& bits);

}  // namespace isolux::volume
