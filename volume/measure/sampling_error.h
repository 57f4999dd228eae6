// What it costs a surface's volume and area that its object is known at the voxels only: by how much those of
// the trilinear isosurface differ from those of the smoothing cubic B-spline of the same voxels.
//
// Of a smooth object f, the trilinear field is f + h^2 f'' / 12 (the mean of x (1 - x) / 2 over a cell) and
// the B-spline f + h^2 f'' / 6, along each axis: the object's surface lies on the trilinear one's other side,
// just as far. Where the object is not resolved (edges, steps of one voxel, terraces) the spline is the
// smoothest field that the voxels allow, and differs from the trilinear one by as much as the object may.
//
// Both differences are integrals over the trilinear surface S, to the leading order of the distance d between
// the two along the outward normal, d = (c - v) / |grad c| with c the spline and v the isovalue:
//   volume: integral of d + (div n) d^2 / 2      n = -grad c / |grad c|, div n = kappa1 + kappa2,
//   area:   integral of (div n) d, and integral of 1 - cos, cos between n and the normal of S.
// (The flux of n through S is the integral of cos, that through the other surface its area, and their
// difference the integral of div n between them.) The two parts of the area may have either sign in the
// object, so their sizes add.
#pragma once

#include <glm/mat3x3.hpp>

#include "volume/grid.h"
#include "volume/measure/cell_measure.h"

namespace isolux::volume {

// Sums over the surface, mm^3 and mm^2.
struct SamplingShift {
  double volume = 0.0, bent = 0.0, rough = 0.0;   // the three integrals
  double measuredArea = 0.0;                      // of the surface whose voxels are all known
  double volumeSquares = 0.0, areaSquares = 0.0;  // of the shares of cells

  double area() const;
  SamplingShift& operator+=(const SamplingShift& other);
};

class SamplingShifts {
 public:
  // `sign`: 1 where inside is f >= isovalue, -1 where it is f <= isovalue.
  SamplingShifts(const Grid& grid, double isovalue, double sign);

  // What this point of the trilinear surface in `cell` stands for; nothing where the spline reaches beyond
  // the border, or voxels are missing.
  SamplingShift at(glm::ivec3 cell, const CellPoint& point) const;

 private:
  const Grid& grid_;
  double isovalue_, sign_;
  glm::dmat3 worldGradient_;  // A^-T
  double voxelMm_;            // cube root of a voxel's volume: no distance is larger, no radius smaller
};

}  // namespace isolux::volume
