// Weights of the uniform quintic B-spline (Schoenberg 1946), and how they fold at the border of a volume.
//
// Of coefficients floor(x)-2 .. floor(x)+3 at fraction t in [0, 1], and of the first two derivatives. Beyond
// the border coefficients go on by point reflection, c(-k) = 2 c(0) - c(k) and c(n-1+k) = 2 c(n-1) -
// c(n-1-k), so what a tap there weighs is added to those within.
#pragma once

#include <algorithm>

namespace isolux::volume {

inline constexpr int kQuinticTaps = 6;

// 120 times the weight of tap i is the sum over p of kQuinticPolynomials[p][i] t^p. Eight taps, as vectors
// have: the last two are none.
inline constexpr int kQuinticPolynomials[6][8] = {{1, 26, 66, 26, 1, 0},    {-5, -50, 0, 50, 5, 0},
                                                  {10, 20, -60, 20, 10, 0}, {-10, 20, 0, -20, 10, 0},
                                                  {5, -20, 30, -20, 5, 0},  {-1, 5, -10, 10, -5, 1}};

// The factor of t^power in the derivative of this order of tap i's weight.
constexpr double quinticFactor(int order, int power, int tap) {
  double factor = kQuinticPolynomials[power + order][tap] / 120.0;
  for (int k = 1; k <= order; ++k) factor *= power + k;
  return factor;
}

template <class Real>
struct QuinticWeights {
  Real w[kQuinticTaps], d1[kQuinticTaps], d2[kQuinticTaps];
};

template <int order, class Real>
[[gnu::always_inline]] constexpr Real quinticWeight(int tap, Real t) {
  Real sum = Real(quinticFactor(order, 5 - order, tap));
  for (int power = 4 - order; power >= 0; --power) sum = sum * t + Real(quinticFactor(order, power, tap));
  return sum;
}

// Always inlined: the kernels of the processor are compiled for instructions that the rest is not.
template <class Real>
[[gnu::always_inline]] constexpr QuinticWeights<Real> quinticWeights(Real t) {
  QuinticWeights<Real> out{};
  for (int tap = 0; tap < kQuinticTaps; ++tap) {
    out.w[tap] = quinticWeight<0>(tap, t);
    out.d1[tap] = quinticWeight<1>(tap, t);
    out.d2[tap] = quinticWeight<2>(tap, t);
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
