// Weights of the uniform cubic B-spline, the same for all that evaluate it on the CPU.
//
// Of samples floor(x)-1 .. floor(x)+2 at fraction t in [0, 1], and of the first two derivatives. Hadwiger et
// al. 2005 eq. (6). Single precision, which the tracer takes for its speed, multiplies by a sixth instead of
// dividing.
#pragma once

namespace isolux::volume {

template <class Real>
struct CubicWeights {
  Real w[4], d1[4], d2[4];
};

constexpr double sixthOf(double x) {
  return x / 6.0;
}
[[gnu::always_inline]] constexpr float sixthOf(float x) {
  return x * (1.0f / 6.0f);
}

// Always inlined: the tracer's kernels are compiled for instructions that the rest is not.
template <class Real>
[[gnu::always_inline]] constexpr CubicWeights<Real> cubicWeights(Real t) {
  const Real s = Real(1) - t, half = Real(0.5), slope = Real(1.5);
  CubicWeights<Real> out{};
  out.w[0] = sixthOf(s * s * s);
  out.w[1] = sixthOf(Real(4) + t * t * (Real(3) * t - Real(6)));
  out.w[2] = sixthOf(Real(4) + s * s * (Real(3) * s - Real(6)));
  out.w[3] = sixthOf(t * t * t);
  out.d1[0] = -half * s * s;
  out.d1[1] = t * (slope * t - Real(2));
  out.d1[2] = -s * (slope * s - Real(2));
  out.d1[3] = half * t * t;
  out.d2[0] = s;
  out.d2[1] = Real(3) * t - Real(2);
  out.d2[2] = Real(3) * s - Real(2);
  out.d2[3] = t;
  return out;
}

}  // namespace isolux::volume
