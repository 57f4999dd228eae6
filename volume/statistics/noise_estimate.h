// How noisy a volume's values are: what decides where gradients and curvatures mean something.
#pragma once

#include "base/progress.h"
#include "volume/grid.h"

namespace isolux::volume {

// Standard deviation of the noise of a voxel's value, data units, as if it were white. Robust: the median
// size of fourth differences along the axes, which smooth structure hardly reaches (second differences along
// axes of fewer than five voxels), at up to 60 000 places that depend only on the dims. Places where the
// values do not change at all (air set to a constant) do not count. At least what storing the values has
// cost: a step / sqrt(12) for integers, the rounding of the largest value for floats; 0 for a grid without
// values.
double estimateNoise(const Grid& grid);
// The same; throws Error{interrupted} once a stop was requested.
double estimateNoise(const Grid& grid, base::Progress& progress);

}  // namespace isolux::volume
