// The points of the surfaces that a picture shows, by the side that is seen.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

namespace isolux::gi {

// Voxel coordinates; NaN where there is none.
struct SeenPoints {
  std::vector<glm::vec3> outer, inner = {};
  bool empty() const { return outer.empty() && inner.empty(); }
  std::size_t size() const { return outer.size() + inner.size(); }
};

}  // namespace isolux::gi
