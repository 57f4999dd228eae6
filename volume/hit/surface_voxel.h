// The voxel by which a surface point belongs to a piece.
//
// Of the trilinear field it is the corner above the point (cornerAbove()). Points of cubic fields, which have
// no pieces of their own, may have that corner outside; there the nearest inside sample of the 4^3 around the
// cell counts, of several as near the first.
#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "volume/visible/inside_level.h"

namespace isolux::volume {

// `cell` within the grid, `local` in [0, 1] of it. Nothing where no voxel around is inside.
std::optional<glm::ivec3> surfaceVoxel(const Grid& grid, InsideLevel level, glm::ivec3 cell,
                                       const glm::dvec3& local);
// `voxel`: a surface point in voxel coordinates.
std::optional<glm::ivec3> surfaceVoxel(const Grid& grid, InsideLevel level, const glm::dvec3& voxel);

}  // namespace isolux::volume
