#include "volume/statistics/interpolated_slices.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "base/quantiles.h"
#include "volume/parallel/parallel_loops.h"

namespace isolux::volume {

namespace {

constexpr int kScanLines = 32;     // across the slices, along each of the other axes
constexpr int kScanSlices = 512;   // at most, from the middle
constexpr int kFewestSlices = 24;  // slices that a period is found in
constexpr int kNeighbours = 3;     // slices to both sides that one is compared with
constexpr double kLeastFrequency = 0.2, kAsStrong = 0.7;
constexpr double kPeriodicPart = 0.25;  // least share of the variance at one frequency
constexpr double kPeriodicDepth =
    0.02;  // least amplitude; 1: slices without and with nothing but second differences

// The mean over places of a slice: root of the share that second differences across it have in first and
// second ones. NaN where nothing differs.
double sliceRoughness(const Grid& grid, int axis, int slice) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const glm::ivec3 dims = grid.dims();
  double sum = 0.0;
  long count = 0;
  const auto value = [&](glm::ivec3 at, int offset) {
    at[axis] += offset;
    return grid.value(at.x, at.y, at.z);
  };
  glm::ivec3 at(slice);
  for (at[v] = 0; at[v] < dims[v]; at[v] += std::max(1, dims[v] / kScanLines))
    for (at[u] = 0; at[u] < dims[u]; at[u] += std::max(1, dims[u] / kScanLines)) {
      const double before = value(at, -1), after = value(at, 1);
      const double second = std::abs(before - 2.0 * value(at, 0) + after), first = std::abs(after - before);
      if (!(first + second > 0.0)) continue;
      sum += std::sqrt(second / (first + second));
      ++count;
    }
  return count > 0 ? sum / static_cast<double>(count) : std::nan("");
}

double interpolatedAlong(const Grid& grid, int axis) {
  const int length = grid.dims()[axis], used = std::min(length - 2, kScanSlices), first = (length - used) / 2;
  if (used < kFewestSlices + 2 * kNeighbours) return 0.0;
  std::vector<double> rough(static_cast<std::size_t>(used));
  parallelEach(rough.size(),
               [&](std::size_t i) { rough[i] = sliceRoughness(grid, axis, first + static_cast<int>(i)); });
  std::vector<double> values, positions, sizes;
  for (std::size_t i = kNeighbours; i + kNeighbours < rough.size(); ++i) {
    double mean = 0.0;
    for (std::size_t k = i - kNeighbours; k <= i + kNeighbours; ++k) mean += rough[k] / (2 * kNeighbours + 1);
    if (!std::isfinite(mean)) continue;
    values.push_back(rough[i] - mean);
    positions.push_back(first + static_cast<double>(i));
    sizes.push_back(std::abs(values.back()));
  }
  if (values.size() < kFewestSlices) return 0.0;
  const double limit = 3.0 * base::median(sizes);
  double squares = 0.0;
  for (double& value : values) {
    value = std::clamp(value, -limit, limit);
    squares += value * value;
  }
  struct Wave {
    double frequency = 0.0, power = 0.0;
  };
  const auto strongest = [&](double least, double most) {
    Wave wave;
    for (double f = least; f <= most; f += 0.1 / length)
      if (const double power = powerAt(values, positions, f); power > wave.power) wave = {f, power};
    return wave;
  };
  Wave wave = strongest(kLeastFrequency, 0.5);
  // Sharp slices have waves of twice the frequency that are as strong.
  if (wave.frequency >= 2.0 * kLeastFrequency)
    if (const Wave slower = strongest(0.5 * wave.frequency - 0.01, 0.5 * wave.frequency + 0.01);
        slower.power >= kAsStrong * wave.power)
      wave = slower;
  const double count = static_cast<double>(values.size());
  const double amplitude = 2.0 * std::sqrt(wave.power * squares) / count;
  return wave.power >= kPeriodicPart * count && amplitude >= kPeriodicDepth ? 1.0 / wave.frequency : 0.0;
}

}  // namespace

double powerAt(std::span<const double> values, std::span<const double> positions, double frequency) {
  std::complex<double> sum = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += std::polar(1.0, 2.0 * std::numbers::pi * frequency * positions[i]) * values[i];
    squares += values[i] * values[i];
  }
  return squares > 0.0 ? std::norm(sum) / squares : 0.0;
}

glm::dvec3 interpolatedSlices(const Grid& grid, base::Progress& progress) {
  glm::dvec3 distances(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    progress.throwIfStopped();
    distances[axis] = interpolatedAlong(grid, axis);
  }
  return distances;
}

}  // namespace isolux::volume
