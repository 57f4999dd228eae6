#include "volume/field/scale_kernel.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace isolux::volume {

namespace {

constexpr double kTail = 1e-9;                 // of a kernel's sum, cut off
constexpr double kGaussianReach = 6.5;         // deviations: beyond, the Gaussian has 1e-10
constexpr double kSplineVariance = 1.0 / 3.0;  // of the cubic B-spline, voxels^2

double sumOf(const HalfKernel& kernel) {
  double sum = kernel[0];
  for (std::size_t k = 1; k < kernel.size(); ++k) sum += 2.0 * kernel[k];
  return sum;
}

double sampledVariance(double parameter) {
  double sum = 1.0, square = 0.0;
  for (int k = 1; k <= static_cast<int>(std::ceil(9.0 * parameter)); ++k) {
    const double weight = 2.0 * std::exp(-0.5 * k * k / (parameter * parameter));
    sum += weight;
    square += weight * k * k;
  }
  return square / sum;
}

}  // namespace

HalfKernel cutToSumOne(HalfKernel kernel) {
  const double sum = sumOf(kernel);
  double beyond = 0.0;
  while (kernel.size() > 1 && beyond + 2.0 * std::abs(kernel.back()) < kTail * std::abs(sum)) {
    beyond += 2.0 * std::abs(kernel.back());
    kernel.pop_back();
  }
  const double left = sumOf(kernel);
  for (double& weight : kernel) weight /= left;
  return kernel;
}

double gaussianParameter(double variance) {
  if (variance >= 1.0) return std::sqrt(variance);
  double low = 0.0, high = 2.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (sampledVariance(middle) < variance ? low : high) = middle;
  }
  return high;
}

HalfKernel gaussianKernel(double deviation) {
  if (!(deviation > 0.0)) return {1.0};
  const double parameter = gaussianParameter(deviation * deviation);
  HalfKernel kernel(static_cast<std::size_t>(std::ceil(kGaussianReach * parameter)) + 1);
  for (std::size_t k = 0; k < kernel.size(); ++k) {
    const double x = static_cast<double>(k) / parameter;
    kernel[k] = std::exp(-0.5 * x * x);
  }
  return cutToSumOne(std::move(kernel));
}

HalfKernel smoothingKernel(scene::Field field, double deviation) {
  if (field == scene::Field::cubic && deviation * deviation < kSplineVariance) return {4.0 / 6.0, 1.0 / 6.0};
  return gaussianKernel(deviation);
}

HalfKernel quinticPrefilter() {
  // The symmetric response of a pole z is -z / (1 - z^2) z^|k|.
  const auto ofPole = [](double sum) {  // z + 1/z
    const double z = 0.5 * (sum + std::sqrt(sum * sum - 4.0));
    HalfKernel response(48);
    for (std::size_t k = 0; k < response.size(); ++k) response[k] = std::pow(z, static_cast<double>(k));
    return cutToSumOne(std::move(response));
  };
  return cutToSumOne(convolved(ofPole(-13.0 + std::sqrt(105.0)), ofPole(-13.0 - std::sqrt(105.0))));
}

HalfKernel convolved(const HalfKernel& a, const HalfKernel& b) {
  const auto reachA = static_cast<int>(a.size()) - 1, reachB = static_cast<int>(b.size()) - 1;
  HalfKernel sum(static_cast<std::size_t>(reachA + reachB) + 1);
  for (int k = 0; k <= reachA + reachB; ++k)
    for (int m = std::max(-reachA, k - reachB); m <= std::min(reachA, k + reachB); ++m)
      sum[static_cast<std::size_t>(k)] +=
          a[static_cast<std::size_t>(std::abs(m))] * b[static_cast<std::size_t>(std::abs(k - m))];
  return sum;
}

HalfKernel scaleKernel(const HalfKernel& smoothing) {
  return cutToSumOne(convolved(smoothing, quinticPrefilter()));
}

}  // namespace isolux::volume
