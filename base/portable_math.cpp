#include "base/portable_math.h"

#include <cmath>
#include <limits>

namespace isolux::base {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kMostRadians = 1e5;  // so that the quarter turns times the parts of pi / 2 are exact
constexpr double kPi = 3.14159265358979311600e+00, kHalfPi = 1.57079632679489655800e+00,
                 kHalfPiRest = 6.12323399573676603587e-17;  // pi / 2 less kHalfPi

// sin(x + rest), |x| at most pi / 4.
double sineOf(double x, double rest) {
  const double z = x * x;
  const double tail = 8.33333333332248946124e-03 +
                      z * (-1.98412698298579493134e-04 +
                           z * (2.75573137070700676789e-06 +
                                z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)));
  const double cube = z * x;
  return x - ((z * (0.5 * rest - cube * tail) - rest) - cube * -1.66666666666666324348e-01);
}

// cos(x + rest), |x| at most pi / 4.
double cosineOf(double x, double rest) {
  const double z = x * x;
  const double tail =
      z * (4.16666666666666019037e-02 +
           z * (-1.38888888888741095749e-03 +
                z * (2.48015872894767294178e-05 +
                     z * (-2.75573143513906633035e-07 +
                          z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)))));
  const double half = 0.5 * z, most = 1.0 - half;
  return most + (((1.0 - most) - half) + (z * tail - x * rest));
}

struct Reduced {
  double x = 0.0, rest = 0.0;  // radians less so many quarter turns
  int quarters = 0;            // modulo 4
};

Reduced reduced(double radians) {
  // pi / 2 in three parts of 33 bits, whose products with a number of 17 bits are exact, and what is left.
  constexpr double part1 = 1.57079632673412561417e+00, part2 = 6.07710050630396597660e-11,
                   part3 = 2.02226624871116645580e-21, left = 8.47842766036889956997e-32;
  const double turns = std::nearbyint(radians / kHalfPi);
  const double a = radians - turns * part1;
  const double b = turns * part2, c = a - b;
  const double lost = (a - c) - b;  // of that difference
  const double d = turns * part3 - lost, e = c - d;
  const double rest = ((c - e) - d) - turns * left;
  const double x = e + rest;
  return {x, (e - x) + rest, static_cast<int>(static_cast<long>(turns) & 3)};
}

// Of acos and asin: (asin(sqrt z) - sqrt z) / sqrt z, z at most 1 / 4.
double arcRatio(double z) {
  const double p = z * (1.66666666666666657415e-01 +
                        z * (-3.25565818622400915405e-01 +
                             z * (2.01212532134862925881e-01 +
                                  z * (-4.00555345006794114027e-02 +
                                       z * (7.91534994289814532176e-04 + z * 3.47933107596021167570e-05)))));
  const double q = 1.0 + z * (-2.40339491173441421878e+00 +
                              z * (2.02094576023350569471e+00 +
                                   z * (-6.88283971605453293030e-01 + z * 7.70381505559019352791e-02)));
  return p / q;
}

}  // namespace

double portableSin(double radians) {
  if (!(std::abs(radians) <= kMostRadians)) return kNone;
  const Reduced r = reduced(radians);
  const double value = (r.quarters & 1) != 0 ? cosineOf(r.x, r.rest) : sineOf(r.x, r.rest);
  return (r.quarters & 2) != 0 ? -value : value;
}

double portableCos(double radians) {
  if (!(std::abs(radians) <= kMostRadians)) return kNone;
  const Reduced r = reduced(radians);
  const double value = (r.quarters & 1) != 0 ? sineOf(r.x, r.rest) : cosineOf(r.x, r.rest);
  return r.quarters == 1 || r.quarters == 2 ? -value : value;
}

double portableExp(double x) {
  if (std::isnan(x)) return kNone;
  if (x < -708.0) return 0.0;
  if (x > 709.0) return std::numeric_limits<double>::infinity();
  constexpr double log2High = 6.93147180369123816490e-01, log2Low = 1.90821492927058770002e-10,
                   inverse = 1.44269504088896338700e+00;
  const double k = std::nearbyint(x * inverse);
  const double high = x - k * log2High, low = k * log2Low, r = high - low, t = r * r;
  const double c = r - t * (1.66666666666666019037e-01 +
                            t * (-2.77777777770155933842e-03 +
                                 t * (6.61375632143793436117e-05 +
                                      t * (-1.65339022054652515390e-06 + t * 4.13813679705723846039e-08))));
  const double y = 1.0 - ((low - (r * c) / (2.0 - c)) - high);
  return std::ldexp(y, static_cast<int>(k));
}

double portableAcos(double cosine) {
  if (!(std::abs(cosine) <= 1.0)) return kNone;
  if (std::abs(cosine) < 0.5) return kHalfPi - (cosine - (kHalfPiRest - cosine * arcRatio(cosine * cosine)));
  if (cosine < 0.0) {
    const double z = 0.5 * (1.0 + cosine), s = std::sqrt(z);
    return kPi - 2.0 * (s + (arcRatio(z) * s - kHalfPiRest));
  }
  const double z = 0.5 * (1.0 - cosine), s = std::sqrt(z);
  if (s == 0.0) return 0.0;
  const double high = static_cast<double>(static_cast<float>(s));  // its square is exact
  const double low = (z - high * high) / (s + high);
  return 2.0 * (high + (arcRatio(z) * s + low));
}

}  // namespace isolux::base
