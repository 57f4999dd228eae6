// Calls functions of the program that take a progress, for tests that watch none.
#pragma once

#include "base/progress.h"
#include "volume/field/coefficients.h"
#include "volume/statistics/histogram.h"
#include "volume/statistics/noise_estimate.h"

namespace isolux::volume {

inline Coefficients interpolatingCoefficients(const Grid& grid) {
  base::Progress unwatched;
  return interpolatingCoefficients(grid, unwatched);
}

inline Histogram makeHistogram(const Grid& grid, int bins = 512) {
  base::Progress unwatched;
  return makeHistogram(grid, bins, unwatched);
}

inline scene::NoiseModel estimateNoise(const Grid& grid) {
  base::Progress unwatched;
  return estimateNoise(grid, unwatched);
}

}  // namespace isolux::volume
