// The distance from any point to the nearest triangle of a mesh: a bounding volume hierarchy.
//
// Lengths in the unit of the points. Building is O(n log n); asking is const and safe from several threads.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "volume/mesh/triangle_mesh.h"
#include "volume/voxels/bounds.h"

namespace isolux::volume {

// The closest point of the triangle abc to p, Ericson, Real-Time Collision Detection (2005), sec. 5.1.5. A
// triangle without area gives the closest point of one of its edges.
glm::dvec3 closestPoint(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

class TriangleTree {
 public:
  // At least one triangle. Those with sides longer than `longestSide` are cut into pieces first: boxes of
  // large triangles overlap, so that each question would look at most of them. On all cores; throws
  // Error{interrupted}.
  TriangleTree(const TriangleMesh& mesh, double longestSide, const base::Progress& progress);

  // How many pieces that makes, counted no further than `most`.
  static std::size_t piecesOf(const TriangleMesh& mesh, double longestSide, std::size_t most,
                              const base::Progress& progress);
  static constexpr std::size_t kBytesOfPiece = 300;  // while it is built

  // The smaller of `limit` and the distance from p to the surface. `nearest` is the nearest triangle of a
  // point near by, or -1: a good one is fast, any is right. It becomes p's where that is nearer than `limit`.
  double distance(const glm::dvec3& p, double limit, int& nearest) const;

 private:
  struct Node {
    Bounds<glm::dvec3> box;
    int first;  // of its triangles; of an inner node: its right child (the left one follows it)
    int count;  // 0: an inner node
  };
  struct Corners {
    glm::dvec3 a, b, c;
  };
  class Builder;

  template <typename F>
  static void forEachPiece(const TriangleMesh& mesh, double longestSide, const base::Progress& progress,
                           F&& f);

  std::vector<Corners> triangles_;  // in the order of the leaves
  std::vector<Node> nodes_;
};

}  // namespace isolux::volume
