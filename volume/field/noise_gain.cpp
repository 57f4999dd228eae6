#include "volume/field/noise_gain.h"

#include <array>
#include <cmath>
#include <cstdlib>

#include "scene/noise.h"

namespace isolux::volume {

namespace {

constexpr int kReach = 24;  // voxels: beyond, correlations and the prefilter's response are below 1e-13

// A symmetric sequence by its distance from the middle.
using Sequence = std::array<double, kReach + 1>;

double at(const Sequence& s, int k) {
  return std::abs(k) <= kReach ? s[static_cast<std::size_t>(std::abs(k))] : 0.0;
}

Sequence convolved(const Sequence& a, const Sequence& b) {
  Sequence sum{};
  for (int k = 0; k <= kReach; ++k)
    for (int m = -kReach; m <= kReach; ++m) sum[static_cast<std::size_t>(k)] += at(a, m) * at(b, k - m);
  return sum;
}

Sequence secondDifference(const Sequence& s) {
  Sequence d{};
  for (int k = 0; k < kReach; ++k)
    d[static_cast<std::size_t>(k)] = at(s, k - 1) - 2.0 * at(s, k) + at(s, k + 1);
  return d;
}

// Centred B-splines of an odd degree at whole numbers.
constexpr Sequence kDegree1{1.0};
constexpr Sequence kDegree3{4.0 / 6.0, 1.0 / 6.0};
constexpr Sequence kDegree5{66.0 / 120.0, 26.0 / 120.0, 1.0 / 120.0};
constexpr Sequence kDegree7{2416.0 / 5040.0, 1191.0 / 5040.0, 120.0 / 5040.0, 1.0 / 5040.0};

// Autocorrelations of b and its first two derivatives.
struct Kernel {
  Sequence value, first, second;
};

Kernel kernelOf(scene::Field field) {
  Kernel kernel;
  if (field == scene::Field::trilinear) {
    kernel = {kDegree3, secondDifference(kDegree1), {}};
  } else {
    kernel = {kDegree7, secondDifference(kDegree5), secondDifference(secondDifference(kDegree3))};
  }
  for (double& v : kernel.first) v = -v;
  return kernel;
}

// Of coefficients instead of samples: the prefilter's response is 6 z / (z^2 - 1) z^|k|, z = sqrt(3) - 2.
Sequence prefiltered(const Sequence& noise) {
  const double z = std::sqrt(3.0) - 2.0;
  Sequence response;
  for (int k = 0; k <= kReach; ++k)
    response[static_cast<std::size_t>(k)] = 6.0 * z / (z * z - 1.0) * std::pow(z, k);
  return convolved(noise, convolved(response, response));
}

// Mean squares of the 0th, first and second derivative along one axis.
std::array<double, 3> squares(const Kernel& kernel, const Sequence& noise) {
  std::array<double, 3> sums{};
  for (int k = -kReach; k <= kReach; ++k) {
    sums[0] += at(noise, k) * at(kernel.value, k);
    sums[1] += at(noise, k) * at(kernel.first, k);
    sums[2] += at(noise, k) * at(kernel.second, k);
  }
  return sums;
}

}  // namespace

NoiseGain noiseGain(scene::Field field, const glm::dvec3& blur) {
  const Kernel kernel = kernelOf(field);
  std::array<std::array<double, 3>, 3> along;
  for (int axis = 0; axis < 3; ++axis) {
    Sequence noise;
    for (int k = 0; k <= kReach; ++k)
      noise[static_cast<std::size_t>(k)] = scene::noiseCorrelation(blur[axis], k);
    if (field == scene::Field::cubic_interpolating) noise = prefiltered(noise);
    along[static_cast<std::size_t>(axis)] = squares(kernel, noise);
  }
  const auto of = [&](int x, int y, int z) {
    return along[0][static_cast<std::size_t>(x)] * along[1][static_cast<std::size_t>(y)] *
           along[2][static_cast<std::size_t>(z)];
  };
  NoiseGain gain;
  gain.gradient = {of(1, 0, 0), of(0, 1, 0), of(0, 0, 1)};
  gain.pure = {of(2, 0, 0), of(0, 2, 0), of(0, 0, 2)};
  gain.mixed = {of(1, 1, 0), of(1, 0, 1), of(0, 1, 1)};
  if (field != scene::Field::trilinear) gain.covariance = gain.mixed;  // by parts, twice
  return gain;
}

}  // namespace isolux::volume
