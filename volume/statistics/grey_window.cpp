#include "volume/statistics/grey_window.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isolux::volume {

namespace {

struct Percentile {
  std::size_t bin;
  double value;
};

// Below which `part` of all counted voxels lie.
Percentile percentileOf(const Histogram& histogram, double part) {
  const auto& counts = histogram.counts;
  const double all = std::accumulate(counts.begin(), counts.end(), 0.0);
  const double binWidth =
      (histogram.maximum - histogram.minimum) / static_cast<double>(std::max<std::size_t>(counts.size(), 1));
  double below = 0.0;
  for (std::size_t bin = 0; bin < counts.size(); ++bin) {
    const auto here = static_cast<double>(counts[bin]);
    if (here > 0.0 && below + here >= part * all)
      return {bin, histogram.minimum + binWidth * (static_cast<double>(bin) + (part * all - below) / here)};
    below += here;
  }
  return {counts.size(), histogram.maximum};
}

}  // namespace

double GreyWindow::greyOf(double value) const {
  if (std::isnan(value)) return value;
  if (!(width > 0.0)) return value >= level ? 1.0 : 0.0;
  return std::clamp((value - level) / width + 0.5, 0.0, 1.0);
}

GreyWindow greyWindow(const Histogram& histogram) {
  Percentile low = percentileOf(histogram, 0.01), high = percentileOf(histogram, 0.99);
  if (low.bin == high.bin) low.value = histogram.minimum, high.value = histogram.maximum;
  const double level = 0.5 * low.value + 0.5 * high.value, width = high.value - low.value;
  return {level, width > 0.0 ? width : 1.0};
}

GreyWindow greyWindow(const scene::Slice& slice, const Histogram& histogram) {
  if (slice.level && slice.width) return {*slice.level, *slice.width};
  const GreyWindow found = greyWindow(histogram);
  return {slice.level.value_or(found.level), slice.width.value_or(found.width)};
}

}  // namespace isolux::volume
