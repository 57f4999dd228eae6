#include "volume/statistics/spline_gap.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include <glm/geometric.hpp>

#include "volume/field/cubic_weights.h"
#include "volume/field/reconstruct.h"
#include "volume/parallel/parallel_loops.h"

namespace isolux::volume {

namespace {

constexpr int kTail = 7;  // samples beyond the spline's own four: the prefilter's response falls by 0.27 each
constexpr int kTaps = 2 * kTail + 4;

// What each sample along an axis weighs for the interpolating spline's value and slope.
struct CardinalTaps {
  std::array<int, kTaps> sample{};
  std::array<double, kTaps> value{}, slope{};
};

// Coefficients are samples convolved with 6 z / (z^2 - 1) z^|k|, z = sqrt(3) - 2 (Unser 1999, box 2); the
// border is a mirror half a sample beyond, as in interpolatingCoefficients().
CardinalTaps cardinalTaps(double coordinate, int count) {
  const double pole = std::sqrt(3.0) - 2.0;
  const int cell = std::clamp(static_cast<int>(std::floor(coordinate)), 0, std::max(count - 2, 0));
  const CubicWeights<double> spline = cubicWeights(coordinate - cell);
  CardinalTaps taps;
  for (int i = 0; i < kTaps; ++i) {
    const auto at = static_cast<std::size_t>(i);
    for (int k = 0; k < 4; ++k) {
      const double response = 6.0 * pole / (pole * pole - 1.0) * std::pow(pole, std::abs(i - kTail - k));
      taps.value[at] += response * spline.w[k];
      taps.slope[at] += response * spline.d1[k];
    }
    const int period = 2 * count, sample = ((cell - 1 - kTail + i) % period + period) % period;
    taps.sample[at] = std::min(sample, period - 1 - sample);
  }
  return taps;
}

struct Gap {
  double value = 0.0;  // spline less trilinear
  glm::dvec3 gradient{0.0};
};

Gap gapAt(const Grid& grid, glm::dvec3 voxel, double trilinear) {
  const glm::ivec3 dims = grid.dims();
  const CardinalTaps x = cardinalTaps(voxel.x, dims.x), y = cardinalTaps(voxel.y, dims.y),
                     z = cardinalTaps(voxel.z, dims.z);
  Gap gap;
  std::visit(
      [&](const auto& voxels) {
        for (std::size_t k = 0; k < kTaps; ++k)
          for (std::size_t j = 0; j < kTaps; ++j) {
            double value = 0.0, slope = 0.0;
            for (std::size_t i = 0; i < kTaps; ++i) {
              const std::size_t index = grid.index(x.sample[i], y.sample[j], z.sample[k]);
              const double sample =
                  static_cast<double>(voxels[index]) - trilinear;  // the weights sum to 1 but for the tail
              value += x.value[i] * sample;
              slope += x.slope[i] * sample;
            }
            gap.value += y.value[j] * z.value[k] * value;
            gap.gradient += glm::dvec3(y.value[j] * z.value[k] * slope, y.slope[j] * z.value[k] * value,
                                       y.value[j] * z.slope[k] * value);
          }
      },
      grid.voxels());
  return gap;
}

}  // namespace

double shareBesideSpline(const Grid& grid, std::span<const glm::dvec3> points, double gapVoxels) {
  std::atomic<std::size_t> counted{0}, beside{0};
  parallelEach(points.size(), [&](std::size_t i) {
    const double stored = grid.storedOfValue(sampleTrilinear(grid, points[i]).value);
    const Gap gap = gapAt(grid, points[i], stored);
    if (!std::isfinite(gap.value)) return;
    ++counted;
    if (std::abs(gap.value) > gapVoxels * glm::length(gap.gradient)) ++beside;
  });
  return counted == 0 ? 0.0 : static_cast<double>(beside) / static_cast<double>(counted);
}

}  // namespace isolux::volume
