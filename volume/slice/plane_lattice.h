// How a plane cuts the cells of a grid: two voxel axes a, b lie along the plane's picture, the third, c,
// follows from them.
//
// c is the axis along which the plane is steepest, so that it changes by at most 1 from one a or b to the
// next. Above each square (i, j) of a and b lie the cut's parts in the cells k = ..., of at most six corners.
// Corners are computed from the lattice alone, so that neighbours have the same ones, bit for bit.
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "volume/slice/slice_plane.h"

namespace isolux::volume {

// An order of points in which an edge has one first end from either side.
inline bool comesFirst(glm::dvec2 p, glm::dvec2 q) {
  return p.x != q.x ? p.x < q.x : p.y < q.y;
}

class PlaneLattice {
 public:
  PlaneLattice(const GridGeometry& geometry, const SlicePlane& plane);

  // The plane meets the grid's cells at all. (It may still miss all of them.)
  bool hasSquares() const { return squares_.x > 0 && squares_.y > 0; }
  glm::ivec2 squares() const { return squares_; }
  double c(glm::dvec2 ab) const { return c0_ + cA_ * ab.x + cB_ * ab.y; }
  glm::dvec3 voxel(glm::dvec2 ab) const;
  glm::ivec3 voxelIndex(int a, int b, int c) const;
  // The cells k that the plane passes above a square: first to last; none where first > last.
  struct Cells {
    int first = 0, last = -1;
  };
  Cells cellsAbove(glm::ivec2 square) const;
  // Corners, counter-clockwise in (a, b), of the part within cell k; fewer than three: none.
  void part(glm::ivec2 square, int k, std::vector<glm::dvec2>& corners) const;

 private:
  glm::dvec2 crossing(glm::dvec2 p, glm::dvec2 q, double level) const;

  int a_ = 0, b_ = 1, c_ = 2;  // voxel axes
  int lastC_ = 0;
  glm::ivec2 squares_{0};
  double c0_ = 0.0, cA_ = 0.0, cB_ = 0.0;
};

}  // namespace isolux::volume
