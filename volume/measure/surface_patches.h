// An isosurface as points that stand for the area about them: one in each cell, or for each piece in it.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "volume/pieces/pieces.h"
#include "volume/skip/min_max_blocks.h"

namespace isolux::volume {

struct SurfacePatch {
  glm::dvec3 voxel{0.0};  // on the trilinear surface
  double areaMm2 = 0.0;
  std::uint32_t piece = Pieces::kNone;
};

// Returns those of the blocks with these y and z, in the order of their cells.
std::vector<SurfacePatch> patchesOfRow(const Pieces& pieces, const MinMaxBlocks& blocks, int blockY,
                                       int blockZ);

}  // namespace isolux::volume
