// Places of a volume as the noise estimate sees them. Internal to this folder.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/progress.h"
#include "volume/grid.h"

namespace isolux::volume {

inline constexpr int kNoiseSpacings = 3;  // of differences: 1, 2 and 3 voxels

// Stored units.
struct NoiseSample {
  double value = 0.0;      // mean of voxels around, not of those next to it
  double steepness = 0.0;  // squared length of the odd differences, per voxel
  std::uint64_t number = 0;
};

// Sizes along each axis for each spacing, of unit variance for white noise, stored units; NaN where something
// is beyond the border, missing, or clipped.
using NoiseDifferences = std::array<std::array<double, kNoiseSpacings>, 3>;

// At places chosen by chance. Reading voxels all over a volume is what takes long: differences are for the
// few places that count. With integers, each voxel gets a part of a step by chance, so that medians are not
// whole numbers of steps: that adds a step^2 / 12 to its variance.
class NoiseSamples {
 public:
  explicit NoiseSamples(const Grid& grid);
  // Those that lie in what is not set to one value.
  std::vector<NoiseSample> list(base::Progress& progress) const;
  std::vector<NoiseDifferences> differencesAt(std::span<const NoiseSample> places,
                                              base::Progress& progress) const;

 private:
  const Grid& grid_;
  double mostFrequent_;
};

}  // namespace isolux::volume
