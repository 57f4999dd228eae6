// A triangle mesh as files give it: points in mm (the world's), and triangles as triples of point indices.
//
// Counter-clockwise seen from outside, where the file knows an outside. Readers promise finite points and
// indices in range; nothing else.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace isolux::volume {

using Triangle = glm::ivec3;

struct TriangleMesh {
  std::vector<glm::dvec3> points;
  std::vector<Triangle> triangles;

  const glm::dvec3& corner(const Triangle& triangle, int i) const {
    return points[static_cast<std::size_t>(triangle[i])];
  }
};

}  // namespace isolux::volume
