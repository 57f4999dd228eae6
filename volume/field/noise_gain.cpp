#include "volume/field/noise_gain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "scene/noise.h"
#include "volume/field/scale_kernel.h"

namespace isolux::volume {

namespace {

constexpr int kReach = 24;  // voxels: beyond, the cubic prefilter's response is below 1e-13

double at(const HalfKernel& s, int k) {
  const auto distance = static_cast<std::size_t>(std::abs(k));
  return distance < s.size() ? s[distance] : 0.0;
}

HalfKernel secondDifference(const HalfKernel& s) {
  HalfKernel d(s.size() + 1);
  for (int k = 0; k < static_cast<int>(d.size()); ++k)
    d[static_cast<std::size_t>(k)] = at(s, k - 1) - 2.0 * at(s, k) + at(s, k + 1);
  return d;
}

// Centred B-splines of odd degrees at whole numbers: times these divisors.
HalfKernel splineOfDegree(int degree) {
  struct Spline {
    double divisor;
    HalfKernel values;
  };
  static const Spline splines[] = {{1.0, {1.0}},
                                   {6.0, {4.0, 1.0}},
                                   {120.0, {66.0, 26.0, 1.0}},
                                   {5040.0, {2416.0, 1191.0, 120.0, 1.0}},
                                   {362880.0, {156190.0, 88234.0, 14608.0, 502.0, 1.0}},
                                   {39916800.0, {15724248.0, 9738114.0, 2203488.0, 152637.0, 2036.0, 1.0}}};
  auto [divisor, values] = splines[degree / 2];
  for (double& value : values) value /= divisor;
  return values;
}

// Autocorrelations of b and its first two derivatives.
struct Autocorrelations {
  HalfKernel value, first, second;
};

// Of the B-spline of this degree; within cells the linear one has no second derivative.
Autocorrelations ofSpline(int degree) {
  Autocorrelations of{splineOfDegree(2 * degree + 1), secondDifference(splineOfDegree(2 * degree - 1)), {}};
  for (double& v : of.first) v = -v;
  if (degree > 1) of.second = secondDifference(secondDifference(splineOfDegree(2 * degree - 3)));
  return of;
}

// The response of the prefilter of the interpolating cubic spline: 6 z / (z^2 - 1) z^|k|, z = sqrt(3) - 2.
HalfKernel cubicPrefilter() {
  const double z = std::sqrt(3.0) - 2.0;
  HalfKernel response(kReach + 1);
  for (int k = 0; k <= kReach; ++k)
    response[static_cast<std::size_t>(k)] = 6.0 * z / (z * z - 1.0) * std::pow(z, k);
  return response;
}

HalfKernel correlationOfNoise(double blur) {
  HalfKernel noise(static_cast<std::size_t>(std::max(kReach, static_cast<int>(10.0 * blur))) + 1);
  for (std::size_t k = 0; k < noise.size(); ++k)
    noise[k] = scene::noiseCorrelation(blur, static_cast<int>(k));
  return noise;
}

// Of coefficients that a filter with this response makes of noise.
HalfKernel filtered(const HalfKernel& noise, const HalfKernel& response) {
  return convolved(noise, convolved(response, response));
}

// Mean squares of the 0th, first and second derivative along one axis.
std::array<double, 3> squares(const Autocorrelations& spline, const HalfKernel& noise) {
  std::array<double, 3> sums{};
  const auto reach = static_cast<int>(noise.size()) - 1;
  for (int k = -reach; k <= reach; ++k) {
    sums[0] += at(noise, k) * at(spline.value, k);
    sums[1] += at(noise, k) * at(spline.first, k);
    sums[2] += at(noise, k) * at(spline.second, k);
  }
  return sums;
}

std::array<double, 3> squaresAlong(scene::Field field, double blur, double deviation) {
  const HalfKernel noise = correlationOfNoise(blur);
  if (field == scene::Field::trilinear) return squares(ofSpline(1), noise);
  if (deviation > 0.0)
    return squares(ofSpline(5), filtered(noise, scaleKernel(smoothingKernel(field, deviation))));
  return squares(ofSpline(3), field == scene::Field::cubic ? noise : filtered(noise, cubicPrefilter()));
}

}  // namespace

NoiseGain noiseGain(scene::Field field, const glm::dvec3& blur, const glm::dvec3& deviations) {
  std::array<std::array<double, 3>, 3> along;
  for (int axis = 0; axis < 3; ++axis)
    along[static_cast<std::size_t>(axis)] = squaresAlong(field, blur[axis], deviations[axis]);
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
