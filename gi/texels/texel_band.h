// Finds the texels that a band of isovalues needs.
#pragma once

#include <vector>

#include "base/progress.h"
#include "gi/lattice/light_lattice.h"
#include "scene/choices.h"
#include "volume/grid.h"

namespace isolux::gi {

// Returns all texels that lookups on the isosurfaces of isovalues [low, high] (data units) can read, and few
// more. Tests the minimum and maximum voxel around each texel. With Field::cubic_interpolating, which
// overshoots its voxels, some may be missing. Multithreaded; throws Error{interrupted}.
std::vector<BlockRequest> texelsOfBand(const LatticeGeometry& lattice, const volume::Grid& grid, double low,
                                       double high, int reach, base::Progress& progress,
                                       scene::Field field = scene::Field::trilinear);

}  // namespace isolux::gi
