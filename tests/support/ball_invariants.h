// Curvature without derivatives: integral invariants over balls, an oracle that shares nothing with the
// splines.
//
// Of the part of a ball of radius r round a point of the surface that lies inside (Pottmann, Wallner, Yang,
// Lai & Hu 2007, "Principal curvatures from the integral invariant viewpoint"), with curvatures positive
// where the surface bends away from inside, up to terms of higher order in r:
//   its volume is 2 pi r^3 / 3 - pi H r^4 / 4 (exact for balls);
//   the second moments about its barycentre along the principal directions are
//   2 pi r^5 / 15 - pi (3 kappa1 + kappa2) r^6 / 48 and the same with kappa1 and kappa2 swapped.
// Moments are summed over the trilinear field at points a quarter of a voxel apart.
#pragma once

#include <glm/vec3.hpp>

#include "volume/grid.h"

namespace isolux::test {

struct BallCurvature {
  double mean = 0.0;                  // from the volume, 1/mm
  double kappa1 = 0.0, kappa2 = 0.0;  // from the moments, kappa1 >= kappa2
};

// voxel: on the surface, further than the ball from the border; the ball cuts no other part of it. Voxels
// are cubes. Inside is f >= isovalue.
BallCurvature ballCurvature(const volume::Grid& grid, double isovalue, glm::dvec3 voxel, double radiusVoxels);

}  // namespace isolux::test
