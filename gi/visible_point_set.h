// Holds the surface points visible in an image, by the visible side.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

namespace isolux::gi {

// Voxel coordinates; NaN where a pixel shows no surface.
struct VisiblePointSet {
  std::vector<glm::vec3> outer, inner = {};
  bool empty() const { return outer.empty() && inner.empty(); }
  std::size_t size() const { return outer.size() + inner.size(); }
};

}  // namespace isolux::gi
