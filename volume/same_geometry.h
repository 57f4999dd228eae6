// Tells whether two grids have their voxels in the same places.
#pragma once

#include "volume/grid.h"

namespace isolux::volume {

bool sameGeometry(const GridGeometry& a, const GridGeometry& b);  // to a millionth of a voxel

}  // namespace isolux::volume
