#include "gi/harmonics/spherical_harmonics.h"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "base/portable_math.h"

namespace isolux::gi {

namespace {

constexpr double pi = std::numbers::pi;

// Y_l^m = sin^m(theta) cos(m phi) Q_l^m(z) for m >= 0 and sin(|m| phi) for m < 0. Q follows from
//   Q_m^m = diagonal[m],  Q_{m+1}^m = up[m] z Q_m^m,
//   Q_l^m = a z Q_{l-1}^m - b Q_{l-2}^m,
// the recurrences of the associated Legendre functions with N_l^m and, for m > 0, sqrt(2) of eq. (12) put in.
template <class Real>
struct Recurrence {
  std::array<Real, maxShOrder> diagonal{}, up{};
  std::array<std::array<Real, maxShOrder>, maxShOrder> a{}, b{};  // [m][l]

  Recurrence() {
    double q = std::sqrt(1.0 / (4.0 * pi));
    for (int m = 0; m < maxShOrder; ++m) {
      // N_m^m (2m - 1)!! from the one before: times sqrt((2m + 1) / (2m)).
      if (m > 0) q *= std::sqrt((2.0 * m + 1.0) / (2.0 * m));
      diagonal[m] = static_cast<Real>(m > 0 ? std::numbers::sqrt2 * q : q);
      up[m] = static_cast<Real>(std::sqrt(2.0 * m + 3.0));
      for (int l = m + 2; l < maxShOrder; ++l) {
        const double l2 = l * l, m2 = m * m, below2 = (l - 1) * (l - 1);
        a[m][l] = static_cast<Real>(std::sqrt((4.0 * l2 - 1.0) / (l2 - m2)));
        b[m][l] =
            static_cast<Real>(std::sqrt((2.0 * l + 1.0) * (below2 - m2) / ((2.0 * l - 3.0) * (l2 - m2))));
      }
    }
  }
};

template <class Real>
const Recurrence<Real> recurrence;

// The order is a template argument so that the loops unroll.
template <int order, class Real>
void evaluateOrder(const glm::vec<3, Real>& d, Real* out) {
  const Recurrence<Real>& r = recurrence<Real>;
  Real cosine = 1, sine = 0;  // sin^m(theta) times those of m phi: the parts of (x + iy)^m
#pragma GCC unroll 8
  for (int m = 0; m < order; ++m) {
    Real below = 0, q = r.diagonal[m];
#pragma GCC unroll 8
    for (int l = m; l < order; ++l) {
      out[l * (l + 1) + m] = q * cosine;
      if (m > 0) out[l * (l + 1) - m] = q * sine;
      const Real next =
          l == m ? r.up[m] * d.z * q : (l + 1 < order ? r.a[m][l + 1] * d.z * q - r.b[m][l + 1] * below : 0);
      below = q;
      q = next;
    }
    const Real turned = d.x * cosine - d.y * sine;
    sine = d.x * sine + d.y * cosine;
    cosine = turned;
  }
}

template <class Real>
void evaluateAny(int order, const glm::vec<3, Real>& d, Real* out) {
  assert(order >= 1 && order <= maxShOrder);
  using Evaluate = void (*)(const glm::vec<3, Real>&, Real*);
  constexpr std::array<Evaluate, maxShOrder> ofOrder = {evaluateOrder<1>, evaluateOrder<2>, evaluateOrder<3>,
                                                        evaluateOrder<4>, evaluateOrder<5>, evaluateOrder<6>,
                                                        evaluateOrder<7>, evaluateOrder<8>};
  ofOrder[order - 1](d, out);
}

}  // namespace

void evaluateSh(int order, glm::vec3 d, float* out) {
  evaluateAny(order, d, out);
}
void evaluateSh(int order, glm::dvec3 d, double* out) {
  evaluateAny(order, d, out);
}

GaussLegendre::GaussLegendre(int count) : nodes(count), weights(count) {
  assert(count >= 1);
  for (int i = 0; i < count; ++i) {
    double x = -base::portableCos(pi * (i + 0.75) / (count + 0.5));  // near the root; Newton's steps to it
    double slope = 1.0;
    for (int step = 0; step < 8; ++step) {
      double below = 1.0, value = x;
      for (int l = 2; l <= count; ++l) {
        const double next = ((2 * l - 1) * x * value - (l - 1) * below) / l;
        below = value;
        value = next;
      }
      slope = count * (x * value - below) / (x * x - 1.0);
      x -= value / slope;
    }
    nodes[i] = x;
    weights[i] = 2.0 / ((1.0 - x * x) * slope * slope);
  }
}

double shWindow(int order, double strength, int l) {
  const double t = pi * strength * l / order;
  return t == 0.0 ? 1.0 : base::portableSin(t) / t;
}

void windowSh(int order, double strength, std::span<glm::dvec3> coefficients) {
  assert(coefficients.size() >= static_cast<std::size_t>(shTerms(order)));
  for (int l = 0; l < order; ++l) {
    const double factor = shWindow(order, strength, l);
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) coefficients[i] *= factor;
  }
}

double clampedCosine(int l) {
  if (l == 1) return 2.0 * pi / 3.0;
  if (l % 2 == 1) return 0.0;
  // 2 pi (-1)^(l/2 - 1) / ((l + 2)(l - 1)) * l! / (2^l (l/2)!^2); l = 0 gives pi.
  double value = 2.0 * pi * (l / 2 % 2 == 1 ? 1.0 : -1.0) / ((l + 2.0) * (l - 1.0));
  for (int k = 1; k <= l / 2; ++k) value *= (2.0 * k - 1.0) / (2.0 * k);
  return value;
}

}  // namespace isolux::gi
