// Points of an isosurface that can be seen from somewhere: what automatic settings are measured at.
//
// Folds and cavities that nobody looks into bend more than what is seen; a statistic over the whole surface
// is decided by them.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "volume/grid.h"
#include "volume/skip/min_max_blocks.h"
#include "volume/visible/hidden_pieces.h"

namespace isolux::volume {

struct VisiblePoint {
  glm::dvec3 voxel{0.0};
  glm::dvec3 direction{0.0};  // of the ray that found it: unit, world
};

// First hits of parallel rays from ten fixed directions, spread evenly over the picture of each: about
// `wanted`, of what is not `hidden`, fewer where the surface is small in its box, none without a surface. The
// same on every machine. On all cores, some milliseconds.
std::vector<VisiblePoint> visiblePoints(const Grid& grid, const MinMaxBlocks& blocks, double isovalue,
                                        std::size_t wanted = 2000, const HiddenPieces& hidden = {});

}  // namespace isolux::volume
