#include "volume/statistics/spline_residual.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include <glm/geometric.hpp>

#include "volume/field/cubic_weights.h"
#include "volume/field/reconstruct.h"
#include "volume/field/tensor_product.h"
#include "volume/parallel/parallel_loops.h"

namespace isolux::volume {

namespace {

constexpr int kTail = 7;  // samples beyond the spline's own four: the prefilter's response falls by 0.27 each
constexpr int kTaps = 2 * kTail + 4;
using CardinalTaps = AxisTaps<kTaps>;

// Coefficients are samples convolved with 6 z / (z^2 - 1) z^|k|, z = sqrt(3) - 2 (Unser 1999, box 2); the
// border is a mirror half a sample beyond, as in interpolatingCoefficients(). No second derivatives.
CardinalTaps cardinalTaps(double coordinate, int count) {
  const double pole = std::sqrt(3.0) - 2.0;
  const auto [cell, t] = cellPosition(coordinate, count);
  const CubicWeights<double> spline = cubicWeights(t);
  CardinalTaps taps;
  for (int i = 0; i < kTaps; ++i) {
    const auto at = static_cast<std::size_t>(i);
    for (int k = 0; k < 4; ++k) {
      const double response = 6.0 * pole / (pole * pole - 1.0) * std::pow(pole, std::abs(i - kTail - k));
      taps.w[at] += response * spline.w[k];
      taps.d1[at] += response * spline.d1[k];
    }
    const int period = 2 * count, sample = ((cell - 1 - kTail + i) % period + period) % period;
    taps.sample[at] = std::min(sample, period - 1 - sample);
  }
  return taps;
}

// The spline less `trilinear`, stored units.
FieldSample residualAt(const Grid& grid, glm::dvec3 voxel, double trilinear) {
  const glm::ivec3 dims = grid.dims();
  const auto sum = [&](const auto& voxels) {
    return tensorProduct(cardinalTaps(voxel.x, dims.x), cardinalTaps(voxel.y, dims.y),
                         cardinalTaps(voxel.z, dims.z),
                         [&](int x, int y, int z) {  // the weights sum to 1 but for the tail
                           return static_cast<double>(voxels[grid.index(x, y, z)]) - trilinear;
                         });
  };
  return grid.visit(sum);
}

}  // namespace

double shareBesideSpline(const Grid& grid, std::span<const glm::dvec3> points, double gapVoxels) {
  std::atomic<std::size_t> counted{0}, beside{0};
  parallelEach(points.size(), [&](std::size_t i) {
    const double stored = grid.storedOfValue(sampleTrilinear(grid, points[i]).value);
    const FieldSample gap = residualAt(grid, points[i], stored);
    if (!std::isfinite(gap.value)) return;
    ++counted;
    if (std::abs(gap.value) > gapVoxels * glm::length(gap.gradient)) ++beside;
  });
  return counted == 0 ? 0.0 : static_cast<double>(beside) / static_cast<double>(counted);
}

}  // namespace isolux::volume
