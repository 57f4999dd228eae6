// How far trilinear isosurfaces lie from those of the spline that passes through the same samples: what
// trilinear hits lose, most of all on structures of one or two voxels, which they draw as beads.
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "volume/grid.h"

namespace isolux::volume {

// Distances beyond this are seen: on wires of a voxel and a half trilinear hits err by 0.12 voxels (median),
// those of the spline by 0.04; on wires of two voxels by 0.06 and 0.01.
inline constexpr double kVisibleResidualVoxels = 0.1;
// Surfaces of which a larger share lies beside the spline gain from its hits: wires of two voxels and
// thinner, twigs, vessels, skin where it is thin; not what is resolved.
inline constexpr double kManyBesideSpline = 0.1;

// The share of `points` further than `gapVoxels` from the spline's isosurface of their own trilinear value:
// to first order |spline - trilinear| / |gradient of the spline|, voxels. Points are voxel coordinates; those
// near missing voxels do not count, 0 without any. The spline's values are summed directly at each point
// (Coefficients would take a pass over the whole volume), to 1e-4 of what the samples differ by. Takes about
// 20 microseconds a point on one core; uses all.
double shareBesideSpline(const Grid& grid, std::span<const glm::dvec3> points,
                         double gapVoxels = kVisibleResidualVoxels);

}  // namespace isolux::volume
