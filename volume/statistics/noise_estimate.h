// How noisy a volume's values are: what decides where gradients and curvatures mean something.
//
// Measured at random places by fourth differences along the axes, f(-2h) - 4 f(-h) + 6 f(0) - 4 f(h) + f(2h),
// which smooth structure hardly reaches, with h of 1, 2 and 3 voxels: for noise of deviation s whose
// neighbours correlate by rho(distance), its square is s^2 (70 - 112 rho(h) + 56 rho(2h) - 16 rho(3h) + 2
// rho(4h)) on average, and what is left of the structure grows with h^8. Sizes are medians, and of each range
// of values only the flattest places count: by odd differences, which are independent of even ones where
// noise is alike in both directions, so that choosing flat places prefers no noise.
#pragma once

#include "base/progress.h"
#include "scene/noise.h"
#include "volume/grid.h"

namespace isolux::volume {

// Places depend only on the dims. What the volume has set to its most frequent value, its least or its most
// (constant air, clipped values) does not count. Deviations are at least what storing the values has cost: a
// step / sqrt(12) for integers, the rounding of the largest value for floats, and no more than that where
// neighbours are alike as in a smooth field; without values for a grid that has none. Throws
// Error{interrupted}.
scene::NoiseModel estimateNoise(const Grid& grid, base::Progress& progress);

}  // namespace isolux::volume
