// The distance from any point to the nearest triangle of a mesh: a bounding volume hierarchy.
//
// Lengths in the unit of the points. Building is O(n log n); asking is const and safe from several threads.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "volume/mesh/triangle_mesh.h"

namespace isolux::volume {

// The closest point of the triangle abc to p, Ericson, Real-Time Collision Detection (2005), sec. 5.1.5. A
// triangle without area gives the closest point of one of its edges.
glm::dvec3 closestPoint(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

class TriangleTree {
 public:
  // At least one triangle. On all cores; throws Error{interrupted}.
  TriangleTree(const TriangleMesh& mesh, const base::Progress& progress);

  // The smaller of `limit` and the distance from p to the surface. `nearest` is the nearest triangle of a
  // point near by, or -1: a good one is fast, any is right. It becomes p's where that is nearer than `limit`.
  double distance(const glm::dvec3& p, double limit, int& nearest) const;

 private:
  struct Node {
    glm::dvec3 low, high;
    int first;  // of its triangles; of an inner node: its right child (the left one follows it)
    int count;  // 0: an inner node
  };
  struct Corners {
    glm::dvec3 a, b, c;
  };
  class Builder;

  std::vector<Corners> triangles_;  // in the order of the leaves
  std::vector<Node> nodes_;
};

}  // namespace isolux::volume
