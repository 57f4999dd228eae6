// The signed distance to a closed triangle mesh as a volume: positive inside, in mm.
//
// Distances are exact (double precision, to the nearest triangle) within kDistanceBand voxels of the surface,
// on both sides, and clamped to +-kDistanceBand voxels beyond. A voxel is inside where the winding number of
// the surface is not 0, counted along the grid's x lines. Each side of a triangle contributes to that count
// the same with opposite sign from either triangle, whatever the rounding, so a closed surface never leaks.
#pragma once

#include "base/progress.h"
#include "volume/grid.h"
#include "volume/mesh/triangle_mesh.h"

namespace isolux::volume {

inline constexpr int kDistanceBand = 16;  // voxels

using BoxMm = Bounds<glm::dvec3>;
BoxMm boundsOf(const TriangleMesh& mesh);  // of the points that triangles use

// A grid of cubic voxels round the box, `voxels` along its longest axis (range [16, 1024]); at least
// four voxels, and a sixteenth of the longest axis in all, lie between box and border.
GridGeometry gridAround(const BoxMm& box, int voxels);

// True where distances can be made: axes at right angles and of one spacing.
bool hasCubicVoxels(const GridGeometry& geometry);

// `closed` as of closedMesh(); a mesh that is not closed leaks along x. `geometry` must have cubic voxels.
// Throws Error{interrupted}.
Grid signedDistance(const TriangleMesh& closed, const GridGeometry& geometry, base::Progress& progress);

}  // namespace isolux::volume
