// The bins of a volume's histogram in stored values, so that voxels can be counted before they are all there.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "volume/grid.h"
#include "volume/statistics/histogram.h"

namespace isolux::volume {

struct HistogramBinning {
  std::size_t count = 1;
  double low = 0.0, high = 0.0;  // of all bins, stored
  bool whole = true;             // whole numbers, `perBin` values from `first` on a bin
  std::int64_t first = 0, perBin = 1;
  double scale = 0.0;  // float32: bins per stored unit

  // At most `most` bins for the stored range [low, high].
  static HistogramBinning of(VoxelType type, double low, double high, int most);

  // Of a value within the range; not NaN.
  template <class T>
  std::size_t binOf(T v) const {
    if constexpr (std::is_integral_v<T>)
      return static_cast<std::size_t>((static_cast<std::int64_t>(v) - first) / perBin);
    else
      return static_cast<std::size_t>(std::max((static_cast<double>(v) - low) * scale, 0.0));
  }
};

// Counts the voxels that are not missing in each bin, on all cores.
template <class T>
std::vector<std::uint64_t> countVoxels(std::span<const T> voxels, const HistogramBinning& bins,
                                       base::Progress& progress);

// What makeHistogram() makes of a volume whose voxels fall into the bins like this. Of `grid` slope and
// intercept.
Histogram histogramOf(const HistogramBinning& bins, std::vector<std::uint64_t> counts, const Grid& grid);

}  // namespace isolux::volume
