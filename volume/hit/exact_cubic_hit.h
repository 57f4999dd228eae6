// First hit of a ray with the isosurface of the tri-cubic B-spline, exactly: the double-precision reference
// for hits on the fields `cubic` and `cubic_interpolating`.
//
// Along a ray's segment through a cell the field is a polynomial of degree 9. Its Bernstein coefficients b_m
// follow from the cell's 64 spline coefficients by convex combinations alone:
//  - per axis, row i of a 4x4 matrix has the weights of the uniform cubic B-spline's blossom (polar form) at
//    (from^(3-i), to^i), `from` and `to` being the segment's ends in the cell; applied to all three axes this
//    gives the Bezier points B(i,j,k) of the box spanned by the segment;
//  - b_m = sum over i+j+k = m of C(3,i) C(3,j) C(3,k) / C(9,m) B(i,j,k), the box's diagonal.
// (Ramshaw 1989, blossoms; the hull and variation-diminishing properties: Farin 2002.) No change of sign in
// the b_m: no crossing. One: exactly one crossing, found to the last bit. More: the segment is halved and
// looked at again, front half first, so that the first crossing cannot be missed.
//
// Cells that hold no surface: for `cubic` those with a missing voxel among their 64, for
// `cubic_interpolating` those with a missing corner (their coefficients come from filled voxels and say
// nothing).
#pragma once

#include <array>
#include <optional>

#include "scene/choices.h"
#include "volume/field/coefficients.h"
#include "volume/grid.h"
#include "volume/hit/cell_walk.h"
#include "volume/hit/exact_hit.h"
#include "volume/skip/min_max_blocks.h"

namespace isolux::volume {

struct CubicHit {
  std::optional<RayHit> hit;
  // False where, before the hit, the ray comes so close to the surface without clearly crossing it that
  // rounding hides whether it touches, misses or crosses twice. `hit` is then the first certain crossing.
  bool certain = true;
  double tUncertain = 0.0;  // of the first such place, where not certain
};

// As firstHit() in all that is not said here: units, sides, tMinimum, tMaximum, hidden. Hits of the trilinear
// field are always certain. `blocks`: of that field (MinMaxBlocks::ofCubic()). `coefficients`: of
// cubic_interpolating, else null.
CubicHit firstHitOfField(const Grid& grid, scene::Field field, const Coefficients* coefficients,
                         const MinMaxBlocks& blocks, double isovalue, const Ray& ray,
                         const HiddenPieces& hidden = {});

// The polynomial of degree 9 along the straight line from `from` to `to`, both in [0,1]^3 of a cell, of the
// spline with these coefficients (x fastest, the cell's own corners at 1 and 2 of each axis), Bernstein form.
using Bernstein9 = std::array<double, 10>;
Bernstein9 alongStretch(const std::array<double, 64>& coefficients, glm::dvec3 from, glm::dvec3 to);

// All changes of side along a cell's segment, s in [0, 1] ascending, and the side that it begins on (unknown
// where rounding hides it). isovalue: data units; coefficients: as above; none that the cell needs is
// missing.
struct SideChanges {
  Side first = Side::unknown;
  std::size_t count = 0;
  std::array<double, 9> s{};
};
SideChanges sideChangesOfCell(const Grid& grid, const Coefficients* coefficients, double isovalue,
                              glm::ivec3 cell, glm::dvec3 from, glm::dvec3 to);

}  // namespace isolux::volume
