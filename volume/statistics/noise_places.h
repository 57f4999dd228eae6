// Places of a volume as the noise estimate sees them. Internal to this folder.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/progress.h"
#include "volume/grid.h"

namespace isolux::volume {

inline constexpr int kNoiseSpacings = 3;  // of differences: 1, 2 and 3 voxels

// Stored units. NaN where something is beyond the border, missing, or clipped.
struct NoisePlace {
  double value = 0.0;      // mean of voxels around, not of those next to it
  double steepness = 0.0;  // squared length of the odd differences, per voxel
  std::array<std::array<double, kNoiseSpacings>,
             3>       // sizes along each axis, of unit variance for white noise
      differences{};  // of unit variance
};

// Those that can be used. With integers, each voxel gets a part of a step by chance, so that medians are not
// whole numbers of steps: that adds a step^2 / 12 to its variance.
std::vector<NoisePlace> noisePlaces(const Grid& grid, base::Progress& progress);

}  // namespace isolux::volume
