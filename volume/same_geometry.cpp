#include "volume/same_geometry.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace isolux::volume {

bool sameGeometry(const GridGeometry& a, const GridGeometry& b) {
  if (a.dims != b.dims) return false;
  const double tolerance = 1e-6 * a.leastSpacingMm();
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec4 voxel((corner & 1) ? a.dims.x - 1 : 0, (corner & 2) ? a.dims.y - 1 : 0,
                           (corner & 4) ? a.dims.z - 1 : 0, 1.0);
    if (glm::length(a.worldFromVoxel * voxel - b.worldFromVoxel * voxel) > tolerance) return false;
  }
  return true;
}

}  // namespace isolux::volume
