#include "volume/statistics/histogram.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <type_traits>
#include <utility>

#include <tbb/combinable.h>

#include "volume/parallel/parallel_steps.h"
#include "volume/statistics/value_bins.h"

namespace isolux::volume {

namespace {

constexpr std::size_t kMaximumPeaks = 8;
// A peak counts when it stands this much above the higher of the valleys beside it, as ln(1 + count).
constexpr double kPeakProminence = 0.2;
constexpr double kSkinHu = -300.0, kBoneHu = 300.0, kLeastApartHu = 200.0;
constexpr double kLeastPart = 0.01;   // of what is not background: below it is no object's
constexpr double kTwoClasses = 0.75;  // between them, of the whole variance
constexpr double kLeastApart = 0.05;  // of suggestions, of the range of values
constexpr double kOutward = 0.6;      // from the threshold of two classes to the outer one of three

using Counts = std::vector<std::uint64_t>;

double between(double low, double high, double t) {
  const double range = high - low;  // overflows for float64 data of both signs near the largest number
  return std::isfinite(range) ? low + t * range : (1.0 - t) * low + t * high;
}

// Counts smoothed by a binomial filter over five bins (with many bins), on a logarithmic scale.
std::vector<double> smoothedLog(const Counts& counts) {
  const auto size = static_cast<int>(counts.size());
  std::vector<double> result(counts.size());
  constexpr double weights[5] = {1.0 / 16, 4.0 / 16, 6.0 / 16, 4.0 / 16, 1.0 / 16};
  for (int i = 0; i < size; ++i) {
    double sum = 0.0;
    if (size < 48) {
      sum = static_cast<double>(counts[static_cast<std::size_t>(i)]);
    } else {
      for (int k = -2; k <= 2; ++k)
        sum += weights[k + 2] *
               static_cast<double>(counts[static_cast<std::size_t>(std::clamp(i + k, 0, size - 1))]);
    }
    result[static_cast<std::size_t>(i)] = std::log1p(sum);
  }
  return result;
}

struct Peak {
  std::size_t bin;
  double prominence;
};

// Topographic prominence: how far one must descend from the peak to reach anything higher. Neighbouring equal
// bins count as one peak, at their first bin.
std::vector<Peak> findPeaks(const std::vector<double>& height) {
  std::vector<Peak> peaks;
  const std::size_t size = height.size();
  for (std::size_t i = 0; i < size; ++i) {
    if (i > 0 && height[i - 1] >= height[i]) continue;
    std::size_t end = i;
    while (end + 1 < size && height[end + 1] == height[i]) ++end;
    if (end + 1 < size && height[end + 1] > height[i]) continue;
    double leftValley = height[i], rightValley = height[i];
    bool higherLeft = false, higherRight = false;
    for (std::size_t k = i; k-- > 0 && !higherLeft;) {
      higherLeft = height[k] > height[i];
      if (!higherLeft) leftValley = std::min(leftValley, height[k]);
    }
    for (std::size_t k = end + 1; k < size && !higherRight; ++k) {
      higherRight = height[k] > height[i];
      if (!higherRight) rightValley = std::min(rightValley, height[k]);
    }
    // Beside a border the ground is 0.
    const double left = higherLeft ? leftValley : 0.0, right = higherRight ? rightValley : 0.0;
    const double prominence = height[i] - std::max(left, right);
    if (prominence >= kPeakProminence) peaks.push_back({(i + end) / 2, prominence});
  }
  std::ranges::stable_sort(peaks, std::greater{}, &Peak::prominence);
  return peaks;
}

// The bins of the background: the fullest bin and, on both sides, the bins down to the next valley or to a
// hundredth of its count (fields that only fade away have no valley). Empty (first > last) when no value is
// frequent enough to be one.
struct BinRange {
  std::size_t first = 1, last = 0;
  bool contains(std::size_t bin) const { return first <= bin && bin <= last; }
};
BinRange backgroundOf(const Counts& counts) {
  const auto total = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
  const std::vector<double> height = smoothedLog(counts);
  const auto fullest =
      static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) - counts.begin());
  BinRange range{fullest, fullest};
  const double floor = height[fullest] - std::log(100.0);
  const auto descends = [&](std::size_t from, std::size_t to) {
    return height[to] < height[from] && height[to] > floor;
  };
  while (range.first > 0 && descends(range.first, range.first - 1)) --range.first;
  while (range.last + 1 < counts.size() && descends(range.last, range.last + 1)) ++range.last;
  std::uint64_t inside = 0;
  for (std::size_t i = range.first; i <= range.last; ++i) inside += counts[i];
  if (5 * inside < total) return {};
  return range;
}

// Otsu 1979, eq. (18): the split of `counts` into two classes with the largest variance between them.
struct OtsuSplit {
  std::size_t last = 0;    // bin of the lower class
  double separated = 0.0;  // how much of the whole variance is between the classes, 0 to 1: eq. (12)
};
OtsuSplit otsuSplit(const Histogram& histogram, const Counts& counts) {
  double total = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    total += static_cast<double>(counts[i]);
    sum += static_cast<double>(counts[i]) * histogram.binCentre(i);
  }
  double whole = 0.0;
  for (std::size_t i = 0; i < counts.size() && total > 0.0; ++i) {
    const double apart = histogram.binCentre(i) - sum / total;
    whole += static_cast<double>(counts[i]) / total * apart * apart;
  }
  double below = 0.0, sumBelow = 0.0, best = -1.0;
  std::size_t bestFirst = 0, bestLast = 0;
  for (std::size_t i = 0; i + 1 < counts.size(); ++i) {
    below += static_cast<double>(counts[i]);
    sumBelow += static_cast<double>(counts[i]) * histogram.binCentre(i);
    const double above = total - below;
    if (below <= 0.0 || above <= 0.0) continue;
    const double difference = sumBelow / below - (sum - sumBelow) / above;
    const double variance = below / total * (above / total) * difference * difference;
    if (variance > best) {
      best = variance;
      bestFirst = i;
    }
    if (variance == best) bestLast = i;  // empty bins between the classes: all splits are equal
  }
  if (best < 0.0) return {counts.size() / 2, 0.0};
  return {bestFirst + (std::max(bestLast, bestFirst) - bestFirst) / 2, whole > 0.0 ? best / whole : 0.0};
}

// The same for three classes: the last bins of the lower and of the middle one.
std::pair<std::size_t, std::size_t> otsuSplits(const Histogram& histogram) {
  const std::size_t size = histogram.counts.size();
  std::vector<double> part(size), sum(size);  // of all up to a bin
  double count = 0.0, values = 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    part[i] = count += static_cast<double>(histogram.counts[i]);
    sum[i] = values += static_cast<double>(histogram.counts[i]) * histogram.binCentre(i);
  }
  const auto square = [](double of, double over) { return over > 0.0 ? of * of / over : 0.0; };
  std::pair<std::size_t, std::size_t> best{0, 0};
  double most = -1.0;
  for (std::size_t i = 0; i + 2 < size; ++i) {
    if (histogram.counts[i] == 0) continue;  // the same split as the bin before
    for (std::size_t k = i + 1; k + 1 < size; ++k) {
      const double variance = square(sum[i], part[i]) + square(sum[k] - sum[i], part[k] - part[i]) +
                              square(values - sum[k], count - part[k]);
      if (variance <= most) continue;
      most = variance;
      best = {i, k};
    }
  }
  // Empty bins between classes: all splits there are equal.
  const auto middle = [&](std::size_t bin) {
    std::size_t last = bin;
    while (last + 2 < size && histogram.counts[last + 1] == 0) ++last;
    return bin + (last - bin) / 2;
  };
  return {middle(best.first), middle(best.second)};
}

double upperEdge(const Histogram& histogram, std::size_t bin) {
  const double bins = static_cast<double>(histogram.counts.size());
  return between(histogram.minimum, histogram.maximum, static_cast<double>(bin + 1) / bins);
}

double countOf(const Counts& counts) {
  return std::accumulate(counts.begin(), counts.end(), 0.0);
}

std::size_t binWith(const Histogram& histogram, double value) {
  const double bins = static_cast<double>(histogram.counts.size());
  const double at = (value - histogram.minimum) / (histogram.maximum - histogram.minimum) * bins;
  return static_cast<std::size_t>(std::clamp(at, 0.0, bins - 1.0));
}

// Said to be, or as only a CT has them without saying so.
bool areHounsfield(const Grid& grid, const std::string& unit) {
  if (unit == "HU") return true;
  return unit.empty() && grid.storedType() == VoxelType::int16 && grid.minimum() >= -3100.0 &&
         grid.minimum() <= -900.0 && grid.maximum() > 500.0;
}

// What histograms suggest beside `first`.
std::vector<double> classBorders(const Histogram& histogram, double first) {
  const BinRange background = backgroundOf(histogram.counts);
  Counts objects = histogram.counts, below, above;
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (background.contains(i)) objects[i] = 0;
  below = above = objects;
  for (std::size_t i = 0; i < objects.size(); ++i) (histogram.binCentre(i) < first ? above : below)[i] = 0;
  std::vector<double> borders;
  for (const Counts& part : {below, above}) {
    if (countOf(part) < std::max(1.0, kLeastPart * countOf(objects))) continue;
    const OtsuSplit split = otsuSplit(histogram, part);
    if (split.separated >= kTwoClasses) borders.push_back(upperEdge(histogram, split.last));
  }
  if (background.first > background.last) return borders;
  // Half way from the background to the highest peak between it and `first`: without one there are only
  // voxels that are partly both.
  const auto fullest = std::max_element(histogram.counts.begin(), histogram.counts.end());
  const double ground = histogram.binCentre(static_cast<std::size_t>(fullest - histogram.counts.begin()));
  for (const double peak : histogram.peaks) {  // the most prominent first
    if ((peak - ground) * (first - peak) <= 0.0 || background.contains(binWith(histogram, peak))) continue;
    borders.push_back(0.5 * (ground + peak));
    break;
  }
  return borders;
}

// The sum of what count(part of the voxels, counts) adds to `size` counts on each thread.
template <class T, class Count>
Counts countedOnThreads(std::span<const T> voxels, std::size_t size, base::Progress& progress,
                        const Count& count) {
  tbb::combinable<Counts> partial([&] { return Counts(size, 0); });
  parallelPieces(voxels.size(), std::size_t{1} << 18, progress, {}, [&](std::size_t begin, std::size_t end) {
    count(voxels.subspan(begin, end - begin), partial.local());
  });
  Counts sum(size, 0);
  partial.combine_each(
      [&](const Counts& counts) { std::ranges::transform(counts, sum, sum.begin(), std::plus()); });
  return sum;
}

// Each value is counted first, in turns, since the same count cannot grow twice at once; then its bin is
// found.
template <class T>
Counts countWholeNumbers(std::span<const T> voxels, const HistogramBinning& bins, base::Progress& progress) {
  constexpr std::size_t values = std::size_t{1} << (8 * sizeof(T)), turns = sizeof(T) == 1 ? 4 : 1;
  const Counts found =
      countedOnThreads(voxels, values * turns, progress, [](std::span<const T> part, Counts& counts) {
        for (std::size_t i = 0; i < part.size(); ++i)
          ++counts[i % turns * values + static_cast<std::make_unsigned_t<T>>(part[i])];
      });
  Counts counts(bins.count, 0);
  for (std::size_t i = 0; i < found.size(); ++i)
    if (found[i] > 0)
      counts[std::min(bins.binOf(static_cast<T>(static_cast<std::make_unsigned_t<T>>(i % values))),
                      bins.count - 1)] += found[i];
  return counts;
}
}  // namespace

template <class T>
Counts countVoxels(std::span<const T> voxels, const HistogramBinning& bins, base::Progress& progress) {
  if constexpr (std::is_integral_v<T>)
    return countWholeNumbers(voxels, bins, progress);
  else
    return countedOnThreads(voxels, bins.count, progress, [&](std::span<const T> part, Counts& counts) {
      for (const T value : part)
        if (!std::isnan(value)) ++counts[std::min(bins.binOf(value), bins.count - 1)];
    });
}
// For large volumes.
template Counts countVoxels(std::span<const float>, const HistogramBinning&, base::Progress&);

double Histogram::binCentre(std::size_t bin) const {
  const auto bins = static_cast<double>(counts.size());
  return between(minimum, maximum, (static_cast<double>(bin) + 0.5) / bins);
}

HistogramBinning HistogramBinning::of(VoxelType type, double low, double high, int most) {
  HistogramBinning bins;
  const std::size_t limit = static_cast<std::size_t>(std::max(most, 1));
  bins.whole = type != VoxelType::float32;
  if (bins.whole) {
    // Whole values per bin, or some bins would hold one value more than others and show as a comb.
    bins.first = static_cast<std::int64_t>(low);
    const std::int64_t values = static_cast<std::int64_t>(high) - bins.first + 1;
    bins.perBin = (values + static_cast<std::int64_t>(limit) - 1) / static_cast<std::int64_t>(limit);
    bins.count = static_cast<std::size_t>((values + bins.perBin - 1) / bins.perBin);
    bins.low = static_cast<double>(bins.first) - 0.5;
    bins.high = bins.low + static_cast<double>(bins.perBin) * static_cast<double>(bins.count);
  } else {
    bins.count = high > low ? limit : 1;
    bins.scale = high > low ? static_cast<double>(bins.count) / (high - low) : 0.0;
    bins.low = low;
    bins.high = high;
  }
  return bins;
}

Histogram histogramOf(const HistogramBinning& bins, std::vector<std::uint64_t> counts, const Grid& grid) {
  Histogram histogram;
  histogram.counts = std::move(counts);
  histogram.minimum = grid.valueOfStored(bins.low);
  histogram.maximum = grid.valueOfStored(bins.high);
  if (grid.slope() < 0.0) {
    std::swap(histogram.minimum, histogram.maximum);
    std::reverse(histogram.counts.begin(), histogram.counts.end());
  }
  for (const Peak& peak : findPeaks(smoothedLog(histogram.counts))) {
    if (histogram.peaks.size() == kMaximumPeaks) break;
    histogram.peaks.push_back(histogram.binCentre(peak.bin));
  }
  return histogram;
}

Histogram makeHistogram(const Grid& grid, int bins, base::Progress& progress) {
  const HistogramBinning binning =
      HistogramBinning::of(grid.storedType(), grid.storedMinimum(), grid.storedMaximum(), bins);
  const auto count = [&](const auto& voxels) { return countVoxels(std::span(voxels), binning, progress); };
  return histogramOf(binning, grid.visit(count), grid);
}

ValueClasses threeClasses(const Histogram& histogram) {
  ValueClasses result;
  const double total = countOf(histogram.counts);
  if (total <= 0.0) return result;
  const auto [lower, upper] = otsuSplits(histogram);
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    const std::size_t of = i <= lower ? 0 : i <= upper ? 1 : 2;
    const double part = static_cast<double>(histogram.counts[i]) / total;
    result.parts[of] += part;
    result.means[of] += part * histogram.binCentre(i);
  }
  for (std::size_t of = 0; of < 3; ++of)
    if (result.parts[of] > 0.0) result.means[of] /= result.parts[of];
  result.borders = {upperEdge(histogram, lower), upperEdge(histogram, upper)};
  return result;
}

double suggestIsovalue(const Grid& grid, const Histogram& histogram, const std::string& unit) {
  const double low = grid.minimum(), high = grid.maximum();
  if (!(low < high)) return low;
  if (areHounsfield(grid, unit) && low < kSkinHu && kSkinHu < high) return kSkinHu;
  const BinRange background = backgroundOf(histogram.counts);
  const double two = upperEdge(histogram, otsuSplit(histogram, histogram.counts).last);
  double edge = two;
  if (background.first <= background.last) {
    const auto [lower, upper] = otsuSplits(histogram);
    const bool dark = histogram.binCentre(background.first) < two;
    edge = std::lerp(two, upperEdge(histogram, dark ? lower : upper), kOutward);
  }
  return low < edge && edge < high ? edge : between(low, high, 0.5);
}

double contrastIsovalue(const Grid& grid, const Histogram& histogram, const std::string& unit) {
  const double low = grid.minimum(), high = grid.maximum();
  if (!(low < high)) return low;
  if (unit == "HU" && low < kSkinHu && kSkinHu < high) return kSkinHu;

  Counts counts = histogram.counts;
  const BinRange background = backgroundOf(counts);
  std::size_t left = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (background.contains(i)) counts[i] = 0;
    left += counts[i] > 0 ? 1 : 0;
  }
  if (left < 2) counts = histogram.counts;  // nothing but background: split that
  const double edge = upperEdge(histogram, otsuSplit(histogram, counts).last);
  return low < edge && edge < high ? edge : between(low, high, 0.5);
}

std::vector<double> suggestIsovalues(const Grid& grid, const Histogram& histogram, const std::string& unit,
                                     double first) {
  const double low = grid.minimum(), high = grid.maximum();
  std::vector<double> result = {first};
  if (!(low < high) || !std::isfinite(high - low)) return result;
  const bool hounsfield = areHounsfield(grid, unit);
  const double least = hounsfield ? kLeastApartHu : kLeastApart * (high - low);
  std::vector<double> others = {kSkinHu, kBoneHu};
  if (!hounsfield) {
    others = classBorders(histogram, first);
    others.insert(others.begin(), contrastIsovalue(grid, histogram, unit));
  }
  for (const double value : others) {
    const bool apart = std::all_of(result.begin(), result.end(),
                                   [&](double other) { return std::abs(value - other) >= least; });
    if (low < value && value < high && apart) result.push_back(value);
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace isolux::volume
