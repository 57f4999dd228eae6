#include "volume/statistics/noise_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "base/quantiles.h"
#include "volume/statistics/noise_samples.h"

namespace isolux::volume {

namespace {

constexpr std::size_t kRanges = 16, kFewestPlaces = 1000;  // of values; places of one
constexpr double kFlat = 0.1;                              // part of a range's places that counts
constexpr double kFlatOfNoise = 0.195;                     // chi^2 of 3 degrees / 3 at that quantile
constexpr double deviationsPerMedian = 1.4826;             // of the absolute value of a normal variable
constexpr std::size_t kSpacings = kNoiseSpacings;
// Voxels, along all axes: what is alike over more is the structure of a simulation that changes quickly.
constexpr double kMostBlur = 1.15;

// Mean square of a fourth difference of unit gain for noise of deviation 1 with this blur, voxels.
double gainOf(double blur, std::size_t spacing) {
  const auto rho = [&](int steps) {
    return scene::noiseCorrelation(blur, steps * static_cast<int>(spacing + 1));
  };
  return (70.0 - 112.0 * rho(1) + 56.0 * rho(2) - 16.0 * rho(3) + 2.0 * rho(4)) / 70.0;
}

// What storing a value as this type has added to its noise, stored units.
double storageNoise(const Grid& grid) {
  const double uniform = 1.0 / std::sqrt(12.0);
  if (grid.storedType() != VoxelType::float32) return uniform;
  const double largest = std::max(std::abs(grid.storedMinimum()), std::abs(grid.storedMaximum()));
  return largest * static_cast<double>(std::numeric_limits<float>::epsilon()) * uniform;
}

double medianOf(std::vector<double>& numbers) {
  return numbers.empty() ? std::nan("") : base::quantile(numbers, 0.5);
}

// The flattest places of a range of values.
struct ValueRange {
  std::vector<NoiseDifferences> places;
  double value = 0.0;      // median, stored units
  double size = 0.0;       // of differences of neighbours, along all axes
  double steepness = 0.0;  // of the steepest of the places, in parts of what is expected of noise alone
  double growth = 0.0;     // of differences over 3 voxels, in parts of those of neighbours
  double unlike = 0.0;     // largest over least of the three axes
  bool constant() const { return unlike == 0.0; }  // no more than storing costs: the others are 0
};

double sizeOf(std::span<const NoiseDifferences> places, std::size_t spacing) {
  std::vector<double> sizes;
  for (const NoiseDifferences& place : places)
    for (const auto& along : place)
      if (!std::isnan(along[spacing])) sizes.push_back(along[spacing]);
  return deviationsPerMedian * medianOf(sizes);
}

double unlikeAxes(std::span<const NoiseDifferences> places) {
  std::vector<double> least, most;
  for (const NoiseDifferences& d : places) {
    if (std::isnan(d[0][0] + d[1][0] + d[2][0])) continue;
    least.push_back(std::min({d[0][0], d[1][0], d[2][0]}));
    most.push_back(std::max({d[0][0], d[1][0], d[2][0]}));
  }
  return medianOf(most) / medianOf(least);
}

ValueRange rangeOf(const NoiseSamples& all, std::span<NoiseSample> places, double least,
                   base::Progress& progress) {
  ValueRange range;
  range.value = places[places.size() / 2].value;
  const auto flat = static_cast<std::ptrdiff_t>(std::ceil(kFlat * static_cast<double>(places.size())));
  std::ranges::nth_element(places, places.begin() + (flat - 1), {}, &NoiseSample::steepness);
  range.places = all.differencesAt(places.first(static_cast<std::size_t>(flat)), progress);
  range.size = sizeOf(range.places, 0);
  if (!(range.size > least)) return range;
  range.growth = sizeOf(range.places, kSpacings - 1) / range.size;
  range.unlike = unlikeAxes(range.places);
  // An odd difference over 6 voxels has the variance s^2 / 18, per voxel, in each of three directions.
  const double noise = std::max(sizeOf(range.places, 1), range.size);
  range.steepness =
      places[static_cast<std::size_t>(flat - 1)].steepness / (kFlatOfNoise * noise * noise / 6.0);
  return range;
}

std::vector<ValueRange> rangesOf(const NoiseSamples& all, std::vector<NoiseSample>& places, double least,
                                 base::Progress& progress) {
  std::ranges::sort(places, {}, &NoiseSample::value);
  const std::size_t count = std::clamp(places.size() / kFewestPlaces, std::size_t{1}, kRanges);
  std::vector<ValueRange> ranges;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t begin = i * places.size() / count, end = (i + 1) * places.size() / count;
    ranges.push_back(rangeOf(all, std::span(places).subspan(begin, end - begin), least, progress));
  }
  return ranges;
}

// Leaves out ranges in which this is clearly more than usual.
void leaveOutUnusual(std::vector<ValueRange>& ranges, double ValueRange::*measure) {
  constexpr double most = 1.25;
  std::vector<double> list;
  for (const ValueRange& range : ranges)
    if (!range.constant() && std::isfinite(range.*measure)) list.push_back(range.*measure);
  if (list.empty()) return;
  const double usual = base::quantile(list, 0.25);
  std::erase_if(ranges,
                [&](const ValueRange& range) { return !range.constant() && range.*measure > most * usual; });
}

// Ranges in which the flattest places are as flat as noise is, else the flattest quarter; without those that
// are bent more than others (the middle of a sheet is flat, too), or more along one axis.
std::vector<ValueRange> believable(std::vector<ValueRange> ranges) {
  constexpr double mostSteep = 3.0;  // 1: noise alone
  std::ranges::sort(ranges, {}, &ValueRange::steepness);
  const std::size_t fewest = (ranges.size() + 3) / 4;
  while (ranges.size() > fewest && !(ranges.back().steepness <= mostSteep)) ranges.pop_back();
  leaveOutUnusual(ranges, &ValueRange::growth);
  leaveOutUnusual(ranges, &ValueRange::unlike);
  std::ranges::sort(ranges, {}, &ValueRange::value);
  return ranges;
}

// The half that is bent the least, of those that are not constant.
std::vector<ValueRange> smoothest(std::vector<ValueRange> ranges) {
  std::erase_if(ranges, [](const ValueRange& range) { return range.constant(); });
  std::ranges::sort(ranges, {}, &ValueRange::growth);
  ranges.resize((ranges.size() + 1) / 2);
  return ranges;
}

using Squares = std::array<double, kSpacings>;

// Mean squares along each axis of all ranges together, in parts of each range's; `rounding`: what storing and
// dithering have added to each place's.
std::array<Squares, 3> squaresAlongAxes(const std::vector<ValueRange>& ranges, double rounding) {
  std::array<Squares, 3> squares{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t h = 0; h < kSpacings; ++h) {
      std::vector<double> sizes, roundings;
      for (const ValueRange& range : ranges)
        for (const NoiseDifferences& place : range.places)
          if (const double size = place[axis][h]; !std::isnan(size)) {
            sizes.push_back(size / range.size);
            roundings.push_back(rounding / (range.size * range.size));
          }
      const double size = deviationsPerMedian * medianOf(sizes);
      squares[axis][h] = std::max(size * size - medianOf(roundings), 0.0);
    }
  return squares;
}

struct Fit {
  double blur = 0.0, misfit = 0.0;
};

// The blur along an axis, given the variance of the noise; what grows with h^8 beside it is structure.
Fit fitBlur(const Squares& measured, double variance) {
  static const std::vector<std::pair<double, Squares>> gains = [] {
    std::vector<std::pair<double, Squares>> list;
    for (int i = 0; i <= 30; ++i) {
      Squares gain;
      for (std::size_t h = 0; h < kSpacings; ++h) gain[h] = gainOf(0.05 * i, h);
      list.emplace_back(0.05 * i, gain);
    }
    return list;
  }();
  Fit best{0.0, std::numeric_limits<double>::infinity()};
  for (const auto& [blur, gain] : gains) {
    double product = 0.0, square = 0.0;
    Squares missing{}, growth{};
    for (std::size_t h = 0; h < kSpacings; ++h) {
      if (!(measured[h] > 0.0)) continue;
      missing[h] = 1.0 - variance * gain[h] / measured[h];
      growth[h] = std::pow(static_cast<double>(h + 1), 8) / measured[h];
      product += missing[h] * growth[h];
      square += growth[h] * growth[h];
    }
    const double structure = square > 0.0 ? std::max(0.0, product / square) : 0.0;
    double misfit = 0.002 * blur * blur;  // of two that fit alike the plainer
    for (std::size_t h = 0; h < kSpacings; ++h) {
      const double error = missing[h] - structure * growth[h];
      misfit += error * error;
    }
    if (misfit < best.misfit) best = {blur, misfit};
  }
  return best;
}

// With the one variance that fits all axes best.
glm::dvec3 fitBlurs(const std::array<Squares, 3>& measured) {
  double low = std::numeric_limits<double>::infinity(), high = 0.0;
  for (const Squares& along : measured)
    for (const double square : along)
      if (square > 0.0) low = std::min(low, square), high = std::max(high, square);
  glm::dvec3 best(0.0);
  double least = std::numeric_limits<double>::infinity();
  for (double variance = low; variance <= 1.4 * high; variance *= 1.04) {
    glm::dvec3 blur(0.0);
    double misfit = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!(measured[axis][0] > 0.0)) continue;
      const Fit fit = fitBlur(measured[axis], variance);
      blur[static_cast<int>(axis)] = fit.blur;
      misfit += fit.misfit;
    }
    if (misfit < least) {
      least = misfit;
      best = blur;
    }
  }
  return best;
}

// How a range's deviation is measured: along the axes along which voxels are the most independent, at the
// least spacing at which they are nearly so.
class VarianceEstimator {
 public:
  explicit VarianceEstimator(const glm::dvec3& blur) {
    constexpr double enough = 0.3;
    for (spacing_ = 0;; ++spacing_) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        gains_[axis] = gainOf(blur[static_cast<int>(axis)], spacing_);
      best_ = *std::max_element(gains_.begin(), gains_.end());
      if (best_ >= enough || spacing_ + 1 == kSpacings) return;
    }
  }
  struct Reading {
    double variance = 0.0;
    std::size_t count = 0;
  };
  Reading read(const ValueRange& range, double rounding) const {
    std::vector<double> sizes;
    double gain = 0.0;
    for (const NoiseDifferences& place : range.places)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double size = place[axis][spacing_];
        if (gains_[axis] < 0.5 * best_ || std::isnan(size)) continue;
        sizes.push_back(size / std::sqrt(gains_[axis]));
        gain = gains_[axis];
      }
    const std::size_t count = sizes.size();
    if (count == 0) return {};
    const double size = deviationsPerMedian * medianOf(sizes);
    return {std::max(0.0, size * size - rounding / gain), count};
  }

 private:
  std::size_t spacing_ = 0;
  std::array<double, 3> gains_{};
  double best_ = 0.0;
};

// What differs by no more than chance becomes alike (empirical Bayes: Efron & Morris 1975): logarithms of
// deviations, each with a standard error of 0.82 / sqrt(count).
void shrink(std::vector<double>& deviations, const std::vector<double>& counts) {
  double mean = 0.0, chance = 0.0, square = 0.0;
  const auto n = static_cast<double>(deviations.size());
  for (const double deviation : deviations) mean += std::log(deviation) / n;
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    const double apart = std::log(deviations[i]) - mean;
    square += apart * apart / std::max(1.0, n - 1.0);
    chance += 0.67 / counts[i] / n;
  }
  const double own = square > 0.0 ? std::clamp(1.0 - chance / square, 0.0, 1.0) : 0.0;
  for (double& deviation : deviations) deviation = std::exp(std::lerp(mean, std::log(deviation), own));
}

}  // namespace

scene::NoiseModel estimateNoise(const Grid& grid, base::Progress& progress) {
  scene::NoiseModel model;
  if (grid.missingCount() == grid.geometry().voxelCount()) return model;
  const double least = storageNoise(grid), slope = std::abs(grid.slope());
  const NoiseSamples all(grid);
  std::vector<NoiseSample> places = all.list(progress);
  if (places.empty()) return {{grid.minimum()}, {least * slope}, glm::dvec3(0.0)};
  // Rounded, and dithered.
  const double step = grid.storedType() == VoxelType::float32 ? 0.0 : 1.0, rounding = step * step / 6.0;
  const std::vector<ValueRange> ranges = believable(rangesOf(all, places, least, progress));
  if (const std::vector<ValueRange> noisy = smoothest(ranges); !noisy.empty())
    model.correlation = fitBlurs(squaresAlongAxes(noisy, rounding));
  if (scene::meanBlur(model.correlation) > kMostBlur)
    return {{grid.minimum()}, {least * slope}, glm::dvec3(0.0)};
  const VarianceEstimator estimator(model.correlation);
  std::vector<double> counts;
  for (const ValueRange& range : ranges) {
    const VarianceEstimator::Reading reading = estimator.read(range, rounding);
    if (reading.count == 0) continue;
    model.values.push_back(grid.valueOfStored(range.value));
    model.deviations.push_back(slope * std::max(std::sqrt(reading.variance + 0.5 * rounding), least));
    counts.push_back(static_cast<double>(reading.count));
  }
  if (model.values.empty()) return {{grid.minimum()}, {least * slope}, glm::dvec3(0.0)};
  shrink(model.deviations, counts);
  if (model.values.front() > model.values.back()) {
    std::reverse(model.values.begin(), model.values.end());
    std::reverse(model.deviations.begin(), model.deviations.end());
  }
  return model;
}

}  // namespace isolux::volume
