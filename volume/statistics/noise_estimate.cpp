#include "volume/statistics/noise_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "base/quantiles.h"
#include "base/random.h"
#include "volume/parallel_steps.h"

namespace isolux::volume {

namespace {

constexpr std::uint64_t kPlaces = 60000;

// What storing a value as this type has added to its noise.
double storageNoise(const Grid& grid) {
  const double uniform = 1.0 / std::sqrt(12.0);
  if (grid.storedType() != VoxelType::float32) return std::abs(grid.slope()) * uniform;
  const double largest = std::max(std::abs(grid.storedMinimum()), std::abs(grid.storedMaximum()));
  return std::abs(grid.slope()) * largest * static_cast<double>(std::numeric_limits<float>::epsilon()) *
         uniform;
}

// The difference along `axis` at a random place, of unit variance for white noise of unit variance; NaN where
// voxels are missing and where all are equal.
double differenceAt(const Grid& grid, int axis, std::uint64_t place) {
  static constexpr std::array<double, 5> fourth{1, -4, 6, -4, 1}, second{1, -2, 1, 0, 0};
  const glm::ivec3 dims = grid.dims();
  const bool wide = dims[axis] >= 5;
  const std::array<double, 5>& weights = wide ? fourth : second;
  const int taps = wide ? 5 : 3;
  glm::ivec3 at;
  for (int i = 0; i < 3; ++i) {
    const int room = i == axis ? dims[i] - taps + 1 : dims[i];
    at[i] =
        static_cast<int>(base::uniformNoise(std::uint64_t{17} + static_cast<std::uint64_t>(i), place) * room);
  }
  double sum = 0.0, norm = 0.0;
  bool constant = true;
  const double first = grid.stored(at.x, at.y, at.z);
  for (int tap = 0; tap < taps; ++tap, ++at[axis]) {
    const double value = grid.stored(at.x, at.y, at.z), weight = weights[static_cast<std::size_t>(tap)];
    constant = constant && value == first;
    sum += weight * value;
    norm += weight * weight;
  }
  return constant ? std::nan("") : sum / std::sqrt(norm);
}

}  // namespace

double estimateNoise(const Grid& grid) {
  base::Progress unwatched;
  return estimateNoise(grid, unwatched);
}

double estimateNoise(const Grid& grid, base::Progress& progress) {
  if (grid.missingCount() == grid.geometry().voxelCount()) return 0.0;
  const std::uint64_t places = std::min<std::uint64_t>(kPlaces, 4 * grid.geometry().voxelCount());
  std::vector<double> sizes(places, std::nan(""));
  parallelPieces(places, 1024, progress, {}, [&](std::size_t begin, std::size_t end) {
    for (std::size_t place = begin; place < end; ++place)
      if (const int axis = static_cast<int>(place % 3); grid.dims()[axis] >= 3)
        sizes[place] = std::abs(differenceAt(grid, axis, place));
  });
  std::erase_if(sizes, [](double size) { return std::isnan(size); });
  const double least = storageNoise(grid);
  if (sizes.empty()) return least;
  constexpr double deviationsPerMedian = 1.4826;  // of the absolute value of a normal variable
  return std::max(deviationsPerMedian * base::quantile(sizes, 0.5) * std::abs(grid.slope()), least);
}

}  // namespace isolux::volume
