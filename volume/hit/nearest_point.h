// The point of a trilinear isosurface that is nearest to a position, for a surface that passes close by.
#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "volume/grid.h"
#include "volume/visible/hidden_pieces.h"

namespace isolux::volume {

// On the isosurface of `isovalue` (stored units), voxel coordinates, in the cells that come within `reach`
// along each axis. Starts where the surface crosses an edge of these cells nearest to `voxel` (exact: the
// field is linear there) and slides along the surface while that brings it closer; distances are those of
// voxel coordinates. Nothing where no edge is crossed, so that no surface comes within reach. Missing voxels
// have no edges. `hidden`: of this isovalue; pieces that have no points.
std::optional<glm::vec3> nearestSurfacePoint(const Grid& grid, glm::vec3 voxel, glm::vec3 reach,
                                             float isovalue, const HiddenPieces& hidden = {});

}  // namespace isolux::volume
