#include "app/study/light_errors.h"

#include <algorithm>
#include <cmath>

#include "base/quantiles.h"

namespace isolux::app {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Mean of independent numbers, and its standard error.
struct Mean {
  double value = 0.0, standardError = 0.0;
};
Mean meanOf(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  double sum = 0.0, squares = 0.0;
  for (const double value : values) sum += value;
  const double mean = sum / count;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {mean, values.size() > 1 ? std::sqrt(squares / (count - 1.0) / count) : 0.0};
}

}  // namespace

double LightErrors::relative(double error) const {
  return mean > 0.0 ? error / mean : nan;
}

LightErrors lightErrorsOf(const std::vector<float>& drawn, const LightReference& reference) {
  LightErrors errors;
  std::vector<double> squares, sums, sizes;  // of a pixel: mean square without noise, mean; of a channel
  double truthSum = 0.0, noise = 0.0;
  for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
    const float* const light = drawn.data() + 3 * reference.pixels[i];
    if (std::isnan(light[0])) continue;
    double square = 0.0, sum = 0.0;
    for (int channel = 0; channel < 3; ++channel) {
      const double expected = reference.irradiance[i][channel], variance = reference.variance[i][channel];
      const double error = static_cast<double>(light[channel]) - expected;
      square += error * error - variance;
      sum += error;
      truthSum += expected;
      noise += variance;
      sizes.push_back(std::abs(error));
      if (sizes.size() > 1 && !(std::abs(error) > std::abs(errors.maximum))) continue;
      errors.maximum = error;
      errors.maximumZ = variance > 0.0 ? error / std::sqrt(variance) : nan;
      errors.maximumPixel = reference.pixels[i];
    }
    squares.push_back(square / 3.0);
    sums.push_back(sum / 3.0);
  }
  errors.pixels = squares.size();
  if (squares.empty()) {
    errors.mean = errors.truthNoise = errors.rmse = errors.rmseStandardError = errors.bias =
        errors.biasStandardError = errors.most99 = errors.most999 = errors.maximum = errors.maximumZ = nan;
    return errors;
  }
  const auto channels = static_cast<double>(sizes.size());
  errors.mean = truthSum / channels;
  errors.truthNoise = std::sqrt(noise / channels);
  const Mean square = meanOf(squares), bias = meanOf(sums);
  // One standard error up: defined also where noise is all there is and the difference falls below 0.
  const double mean = std::max(square.value, 0.0);
  errors.rmse = std::sqrt(mean);
  errors.rmseStandardError = std::sqrt(mean + square.standardError) - errors.rmse;
  errors.bias = bias.value;
  errors.biasStandardError = bias.standardError;
  errors.most99 = base::quantile(sizes, 0.99);
  errors.most999 = base::quantile(sizes, 0.999);
  return errors;
}

}  // namespace isolux::app
