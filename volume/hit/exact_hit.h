// Finds the exact first hit of a ray with the trilinear isosurface: the double-precision reference for all
// other hit finders.
//
// The ray is traversed cell by cell; in each cell the cubic along the ray is solved for its first root. No
// crossing is missed: thin sheets, double crossings, rays along axes and through corners included. Cells with
// a missing corner contain no surface.
#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "volume/grid.h"
#include "volume/hit/cell_walk.h"
#include "volume/skip/min_max_blocks.h"
#include "volume/visible/hidden_pieces.h"

namespace isolux::volume {

struct RayHit {
  double t = 0.0;           // along the ray, in units of |direction|
  glm::dvec3 voxel{0.0};    // hit position, voxel coordinates
  double valueError = 0.0;  // |f - isovalue| at the hit, data units
  bool entering = false;    // f rises through the isovalue along the ray
};

// Returns the first crossing with t in [tMinimum, tMaximum]. The ray is in voxel space. A crossing is a
// change of (f >= isovalue); touching without crossing is no hit. A ray that starts on the surface does not
// hit it there. A non-finite or zero ray hits nothing. If a ray runs in a plane between two cells, one of
// them decides (this matters only with missing voxels). `hidden`: of this isovalue; (f >= isovalue) is then
// restricted to visible components.
std::optional<RayHit> firstHit(const Grid& grid, const MinMaxBlocks& blocks, double isovalue, const Ray& ray,
                               const HiddenPieces& hidden = {});

}  // namespace isolux::volume
