// Volume, area and sensitivity of what a trilinear isosurface makes of one cell, by quadrature of its slices.
//
// A cell is cut into slices across the axis along which the field changes least. In a slice the field is
// bilinear, its isocurve pieces of hyperbolas; with ds the curve's length and s the slice's field,
//   dtau = ds / |grad s| = |dx| / |s_y| = |dy| / |s_x|
// has no poles on a piece, and, everything in voxels of the cell,
//   volume = integral of the area inside, by Green's theorem,      area = integral of |grad f|_w dtau dt,
//   d volume / d isovalue = - integral of dtau dt,                 |g|_w^2 = g^T (A^T A)^-1 g,
// times |det A|. Between the breaks (where the isovalue passes a corner of the slice, and where the
// slice's asymptotic decider changes) all are smooth in t; Gauss's rules of three and two points are
// compared, and a segment is halved until they agree. A plateau at the isovalue is inside: its surface is the
// one that surfaces of isovalues a little farther out come to. Pure functions, any thread.
#pragma once

#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "volume/hit/bernstein_cubic.h"

namespace isolux::volume {

// What a length, an area and a volume in voxels are in mm.
struct CellMetric {
  explicit CellMetric(const glm::dmat3& worldFromVoxel);  // linear part

  glm::dmat3 gradients{1.0};  // (A^T A)^-1: squares of world gradients from those per voxel
  double cellMm3 = 1.0;       // |det A|
  double faceMm2 = 1.0;       // cellMm3^(2/3)
};

struct CellMeasure {
  double volume = 0.0;  // mm^3, of f >= 0 in the cell
  double area = 0.0;    // mm^2, of f = 0 in it
  double sensitivity =
      0.0;  // integral of 1 / |g| over the surface: by what the volume shrinks with the isovalue
  double volumeError = 0.0;  // sums of what the two rules differ by: more than the quadrature errs
  double areaError = 0.0;

  CellMeasure& operator+=(const CellMeasure& other);
};

// A node of the quadrature: a point of the surface and the area it stands for.
struct CellPoint {
  glm::dvec3 local{0.0};     // in [0, 1]^3 of the cell, on f = 0
  glm::dvec3 gradient{0.0};  // of the trilinear field, per voxel
  double area = 0.0;         // mm^2
};

// corners: the field less the isovalue, x fastest, finite; inside is >= 0. No sign changes: 0 or the whole
// cell. `points`, where given, are appended; their areas sum to that of the result.
CellMeasure measureCell(const CellCorners& corners, const CellMetric& metric,
                        std::vector<CellPoint>* points = nullptr);

// The same of the part of the cell between `low` and `high`, in [0, 1]^3 of it.
CellMeasure measureCellPart(const CellCorners& corners, const CellMetric& metric, const glm::dvec3& low,
                            const glm::dvec3& high, std::vector<CellPoint>* points = nullptr);

}  // namespace isolux::volume
