// Weights of the uniform quintic B-spline (Schoenberg 1946), and how they fold at the border of a volume.
//
// Of coefficients floor(x)-2 .. floor(x)+3 at fraction t in [0, 1], and of the first two derivatives. Beyond
// the border coefficients go on by point reflection, c(-k) = 2 c(0) - c(k) and c(n-1+k) = 2 c(n-1) -
// c(n-1-k), so what a tap there weighs is added to those within.
#pragma once

#include <algorithm>

namespace isolux::volume {

inline constexpr int kQuinticTaps = 6;

template <class Real>
struct QuinticWeights {
  Real w[kQuinticTaps], d1[kQuinticTaps], d2[kQuinticTaps];
};

// Always inlined: the kernels of the processor are compiled for instructions that the rest is not.
template <class Real>
[[gnu::always_inline]] constexpr QuinticWeights<Real> quinticWeights(Real t) {
  QuinticWeights<Real> out{};
  const Real parts[2] = {t, Real(1) - t};
  for (int side = 0; side < 2; ++side) {  // taps 0, 1, 2; and mirrored 5, 4, 3, whose slopes change sign
    const Real a = parts[side], b = parts[1 - side], b2 = b * b;
    const int i = side == 0 ? 0 : 5, step = side == 0 ? 1 : -1;
    const Real sign = side == 0 ? Real(1) : Real(-1);
    out.w[i] = b2 * b2 * b * Real(1.0 / 120.0);
    out.d1[i] = -sign * b2 * b2 * Real(1.0 / 24.0);
    out.d2[i] = b2 * b * Real(1.0 / 6.0);
    out.w[i + step] =
        (Real(26) + a * (Real(-50) + a * (Real(20) + a * (Real(20) + a * (Real(-20) + Real(5) * a))))) *
        Real(1.0 / 120.0);
    out.d1[i + step] = sign * (Real(-10) + a * (Real(8) + a * (Real(12) + a * (Real(-16) + Real(5) * a)))) *
                       Real(1.0 / 24.0);
    out.d2[i + step] = (Real(2) + a * (Real(6) + a * (Real(-12) + Real(5) * a))) * Real(1.0 / 6.0);
    const Real a2 = a * a;
    out.w[i + 2 * step] = (Real(66) + a2 * (Real(-60) + a2 * (Real(30) - Real(10) * a))) * Real(1.0 / 120.0);
    out.d1[i + 2 * step] = sign * a * (Real(-12) + a2 * (Real(12) - Real(5) * a)) * Real(1.0 / 12.0);
    out.d2[i + 2 * step] = (Real(-6) + a2 * (Real(18) - Real(10) * a)) * Real(1.0 / 6.0);
  }
  return out;
}

// Six coefficients of one axis, `first` and those behind it, and what they weigh. Of an axis of n < 6 voxels
// the last 6 - n weigh nothing and are not there.
template <class Real>
struct QuinticTaps {
  int first = 0;
  QuinticWeights<Real> weights;
};

// Adds tap k of `from` to the taps within, which begin at `first`. Ends because reflections approach the
// axis.
template <class Real>
[[gnu::always_inline]] constexpr void foldQuinticTap(const QuinticWeights<Real>& from, int tap, int k, int n,
                                                     QuinticTaps<Real>& to) {
  const auto add = [&](int at, Real factor) {
    to.weights.w[at - to.first] += factor * from.w[tap];
    to.weights.d1[at - to.first] += factor * from.d1[tap];
    to.weights.d2[at - to.first] += factor * from.d2[tap];
  };
  Real sign = Real(1);
  while (k < 0 || k > n - 1) {
    const int border = k < 0 ? 0 : n - 1;
    add(border, Real(2) * sign);
    sign = -sign;
    k = 2 * border - k;
  }
  add(k, sign);
}

// At `cell` + t of an axis of n voxels; cell in [0, max(n - 2, 0)]. An axis of one voxel is constant.
template <class Real>
[[gnu::always_inline]] constexpr QuinticTaps<Real> quinticTaps(int cell, Real t, int n) {
  QuinticTaps<Real> out{};
  if (n == 1) {
    out.weights.w[0] = Real(1);
    return out;
  }
  const QuinticWeights<Real> weights = quinticWeights(t);
  out.first = std::max(std::min(cell - 2, n - kQuinticTaps), 0);
  if (n >= kQuinticTaps && out.first == cell - 2) {
    out.weights = weights;
    return out;
  }
  for (int tap = 0; tap < kQuinticTaps; ++tap) foldQuinticTap(weights, tap, cell - 2 + tap, n, out);
  return out;
}

}  // namespace isolux::volume
