// The edges of a mesh, each once, and what splitting them makes of its triangles.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "volume/mesh/triangle_mesh.h"

namespace isolux::volume {

class MeshEdges {
 public:
  MeshEdges() = default;
  explicit MeshEdges(const std::vector<Triangle>& triangles);

  std::size_t count() const { return ends_.size(); }
  // Side i of a triangle leads from its corner i to the next.
  std::size_t of(std::size_t triangle, int side) const {
    return ofSides_[3 * triangle + static_cast<std::size_t>(side)];
  }
  std::pair<std::size_t, std::size_t> ends(std::size_t edge) const { return ends_[edge]; }
  std::size_t open() const { return open_; }  // not of two triangles

 private:
  std::vector<std::pair<std::size_t, std::size_t>> ends_;
  std::vector<std::size_t> ofSides_;
  std::size_t open_ = 0;
};

// split: of each edge the point in its middle, -1 where it stays whole. Neighbours agree, so no crack opens.
std::vector<Triangle> splitTriangles(const TriangleMesh& mesh, const MeshEdges& edges,
                                     const std::vector<int>& split);

// Points at exactly the same place become one, triangles with fewer than three corners go. `marks`: one for
// each point, goes with them.
void mergeEqualPoints(TriangleMesh& mesh, std::vector<char>& marks, const base::Progress& progress);

}  // namespace isolux::volume
