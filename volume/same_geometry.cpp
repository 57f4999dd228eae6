#include "volume/same_geometry.h"

#include <glm/geometric.hpp>

namespace isolux::volume {

bool sameGeometry(const GridGeometry& a, const GridGeometry& b) {
  if (a.dims != b.dims) return false;
  const double tolerance = 1e-6 * a.leastSpacingMm();
  const std::array<glm::dvec3, 8> corners = a.corners(), others = b.corners();
  for (std::size_t i = 0; i < 8; ++i)
    if (glm::length(corners[i] - others[i]) > tolerance) return false;
  return true;
}

}  // namespace isolux::volume
