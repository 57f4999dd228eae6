// The curve f = isovalue in a part of a plane that lies in one cell: found on triangles that are split where
// they may hide something.
//
// Within a cell the trilinear field is a cubic polynomial on any triangle of the plane, given exactly by its
// values at ten points; its Bernstein coefficients hold it between them (Farin 2002). An edge of a triangle
// is split while the field may pass the isovalue on it more than once, or passes it on one longer than
// kLongestCurveEdge; a triangle whose inside may hold a closed curve is split about its middle. Splitting an
// edge depends on that edge alone, so that neighbours agree. Both end at kShortestCurveEdge: what is smaller
// may be missed. A cubic field is a polynomial of degree 9: there the triangles are first split to
// kLongestCurveEdge, on which the cubic through ten of its points stands for it.
#pragma once

#include <vector>

#include "volume/slice/plane_lattice.h"
#include "volume/slice/slice_values.h"

namespace isolux::volume {

inline constexpr double kLongestCurveEdge = 0.36, kShortestCurveEdge = 1.0 / 64.0;  // voxels

// An edge that the curve passes, by its ends; the same from either side.
struct CurveEdge {
  glm::dvec2 low, high;  // (a, b)
  bool operator==(const CurveEdge&) const = default;
};

// From one edge to another, the inside (f >= isovalue) on its left in (a, b).
struct CurvePiece {
  CurveEdge from, to;
  glm::dvec2 start, end;  // on the curve
};

class CellCurves {
 public:
  CellCurves(const SliceField& field, const PlaneLattice& lattice, double isovalue);

  // Adds what lies in cell k above the square. Cells with missing corners hold no surface.
  void find(glm::ivec2 square, int k, std::vector<CurvePiece>& pieces);

 private:
  struct Corner {
    glm::dvec2 at{0.0};
    double f = 0.0;  // above the isovalue, data units
  };
  // Bernstein coefficients between the ends of an edge, from the first end to the second.
  struct Edge {
    double inner[2];
    bool split;
  };
  bool mayHoldCurve(glm::ivec2 square, int k);
  double depth(glm::dvec2 at) const;
  Corner corner(glm::dvec2 at) const { return {at, depth(at)}; }
  Edge edgeOf(const Corner& p, const Corner& q) const;
  void triangle(const Corner& a, const Corner& b, const Corner& c, int level);
  void withSplits(const Corner (&corners)[3], const bool (&split)[3], int level);
  bool mayHideCurve(const Corner& a, const Corner& b, const Corner& c, const Edge (&edges)[3]) const;
  void cross(const Corner& a, const Corner& b, const Corner& c);
  glm::dvec2 rootOn(const Corner& p, const Corner& q) const;

  const SliceField& field_;
  const PlaneLattice& lattice_;
  const double isovalue_;
  glm::ivec2 square_{0};
  int k_ = 0;
  double corners_[8] = {};  // of the cell, above the isovalue: a, then b, then c
  double rounding_ = 0.0;   // depths that are as good as 0
  std::vector<glm::dvec2> part_;
  std::vector<CurvePiece>* pieces_ = nullptr;
};

}  // namespace isolux::volume
