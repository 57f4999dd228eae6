// Sums samples with weights that are products of one weight per axis.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "volume/field/reconstruct.h"

namespace isolux::volume {

// Where a coordinate lies on an axis: the first of its two samples, and the fraction behind it. Coordinates
// beyond the axis are clamped.
struct CellPosition {
  int cell;
  double t;
};
inline CellPosition cellPosition(double coordinate, int samples) {
  // A NaN coordinate stays NaN in std::clamp; max/min in this order turn it into 0.
  const double x = std::min(std::max(0.0, coordinate), static_cast<double>(samples - 1));
  const int cell = std::clamp(static_cast<int>(std::floor(x)), 0, std::max(samples - 2, 0));
  return {cell, x - cell};
}

// Holds the samples of one axis, and their weights for the value and the first two derivatives.
template <std::size_t taps>
struct AxisTaps {
  std::size_t count = taps;  // those behind it are not there
  std::array<int, taps> sample{};
  std::array<double, taps> w{}, d1{}, d2{};
};

// Returns value, gradient and Hessian from the same samples, fetch(x, y, z). Sums over x, then y, then z.
// `Taps`: as AxisTaps.
template <class Taps, class Fetch>
FieldSample tensorProduct(const Taps& x, const Taps& y, const Taps& z, const Fetch& fetch) {
  FieldSample out;
  for (std::size_t k = 0; k < z.count; ++k) {
    // Of the plane: f, fx, fy, fxx, fxy, fyy.
    double f = 0, fx = 0, fy = 0, fxx = 0, fxy = 0, fyy = 0;
    for (std::size_t j = 0; j < y.count; ++j) {
      double v = 0, vx = 0, vxx = 0;
      for (std::size_t i = 0; i < x.count; ++i) {
        const double s = fetch(x.sample[i], y.sample[j], z.sample[k]);
        v += x.w[i] * s;
        vx += x.d1[i] * s;
        vxx += x.d2[i] * s;
      }
      f += y.w[j] * v;
      fx += y.w[j] * vx;
      fy += y.d1[j] * v;
      fxx += y.w[j] * vxx;
      fxy += y.d1[j] * vx;
      fyy += y.d2[j] * v;
    }
    out.value += z.w[k] * f;
    out.gradient += glm::dvec3(z.w[k] * fx, z.w[k] * fy, z.d1[k] * f);
    out.hessian[0][0] += z.w[k] * fxx;
    out.hessian[1][1] += z.w[k] * fyy;
    out.hessian[2][2] += z.d2[k] * f;
    out.hessian[1][0] += z.w[k] * fxy;
    out.hessian[2][0] += z.d1[k] * fx;
    out.hessian[2][1] += z.d1[k] * fy;
  }
  out.hessian[0][1] = out.hessian[1][0];
  out.hessian[0][2] = out.hessian[2][0];
  out.hessian[1][2] = out.hessian[2][1];
  return out;
}

}  // namespace isolux::volume
