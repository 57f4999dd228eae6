#include "volume/statistics/scale_errors.h"

#include <algorithm>
#include <limits>

namespace isolux::volume {

namespace {

// How well the noise in a mean square is known: noise estimate, number of points.
constexpr double kNoiseKnown = 0.05;
constexpr double kDrowned = 0.25;  // a change of shape, in parts of the next
// Estimates are not doubted for less.
constexpr double kClearlyLess = 0.6;
// A surface changes about as much from one scale to the next on its way to fine ones, or less.
constexpr double kMostGrowth = 1.5;
constexpr std::size_t kRoughSteps = 2;  // where what has no shape shows: 1 and 2, about a voxel

// Most that explains no change by more than noise.
double mostNoise(std::span<const ScaleStep> steps) {
  double most = std::numeric_limits<double>::infinity();
  for (const ScaleStep& step : steps)
    if (step.changeOfNoise > 0.0) most = std::min(most, step.change / step.changeOfNoise);
  return most;
}

// Least with which what is left of shape does not grow toward fine scales.
double leastNoise(std::span<const ScaleStep> steps) {
  double least = 0.0;
  for (std::size_t i = 1; i <= kRoughSteps && i + 2 < steps.size(); ++i) {
    const ScaleStep &fine = steps[i], &coarse = steps[i + 1];
    const double ofNoise = fine.changeOfNoise - kMostGrowth * coarse.changeOfNoise;
    if (ofNoise > 0.0) least = std::max(least, (fine.change - kMostGrowth * coarse.change) / ofNoise);
  }
  return least;
}

// Of shape alone, coarse scales first: the measured one and the one expected, by their uncertainties.
std::vector<double> changesOfShape(std::span<const ScaleStep> steps, double noise) {
  std::vector<double> changes(steps.size(), 0.0);
  for (std::size_t i = steps.size() - 1; i-- > 0;) {
    const double ofNoise = noise * steps[i].changeOfNoise, measured = steps[i].change - ofNoise;
    if (i + 2 == steps.size()) {
      changes[i] = std::max(0.0, measured);
      continue;
    }
    const double expected = kDrowned * changes[i + 1], unsure = kNoiseKnown * ofNoise;
    const double sum = expected * expected + unsure * unsure;
    changes[i] = std::max(
        0.0, sum > 0.0 ? (measured * expected * expected + expected * unsure * unsure) / sum : measured);
  }
  return changes;
}

}  // namespace

double surfaceNoise(std::span<const ScaleStep> steps, double estimated) {
  if (steps.size() < 2) return estimated;
  const double most = mostNoise(steps);
  if (most < kClearlyLess * estimated) return most;
  return std::max(estimated, std::min(leastNoise(steps), most));
}

ScaleErrors scaleErrors(std::span<const ScaleStep> steps, double noiseVariance) {
  ScaleErrors errors;
  if (steps.empty()) return errors;
  errors.noiseVariance = noiseVariance;
  const std::vector<double> changes = changesOfShape(steps, noiseVariance);
  double lost = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    errors.noise.push_back(errors.noiseVariance * steps[i].noise);
    errors.lost.push_back(lost);
    lost += changes[i];
    if (errors.noise[i] + errors.lost[i] < errors.noise[errors.best] + errors.lost[errors.best])
      errors.best = i;
  }
  return errors;
}

}  // namespace isolux::volume
