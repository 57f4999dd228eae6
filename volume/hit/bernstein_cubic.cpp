#include "volume/hit/bernstein_cubic.h"

#include <cmath>
#include <utility>

#include "volume/hit/cell_walk.h"

namespace isolux::volume {

double trilinear(const CellCorners& c, const glm::dvec3& p) {
  return mix(mix(mix(c[0], c[1], p.x), mix(c[2], c[3], p.x), p.y),
             mix(mix(c[4], c[5], p.x), mix(c[6], c[7], p.x), p.y), p.z);
}

BernsteinCubic BernsteinCubic::along(const CellCorners& corners, const glm::dvec3& from,
                                     const glm::dvec3& to) {
  // The coefficients are the polar form of the trilinear function at the segment's two ends.
  const glm::dvec3 end[2] = {from, to};
  const auto f = [&](int i, int j, int k) { return trilinear(corners, {end[i].x, end[j].y, end[k].z}); };
  return {{f(0, 0, 0), (f(1, 0, 0) + f(0, 1, 0) + f(0, 0, 1)) / 3.0,
           (f(1, 1, 0) + f(1, 0, 1) + f(0, 1, 1)) / 3.0, f(1, 1, 1)}};
}

double BernsteinCubic::operator()(double s) const {  // de Casteljau
  const double b01 = mix(b[0], b[1], s), b12 = mix(b[1], b[2], s), b23 = mix(b[2], b[3], s);
  return mix(mix(b01, b12, s), mix(b12, b23, s), s);
}

// The roots of c0 (1-s)^2 + 2 c1 s (1-s) + c2 s^2.
int BernsteinCubic::extrema(std::array<double, 2>& s) const {
  const double c0 = b[1] - b[0], c1 = b[2] - b[1], c2 = b[3] - b[2];
  const double a = (c0 - c1) + (c2 - c1), h = c1 - c0;  // a s^2 + 2 h s + c0
  const double discriminant = h * h - a * c0;
  if (!(discriminant >= 0.0)) return 0;
  const double q = -(h + std::copysign(std::sqrt(discriminant), h));
  std::size_t count = 0;
  for (const double root : {a != 0.0 ? q / a : -1.0, q != 0.0 ? c0 / q : -1.0})
    if (root > 0.0 && root < 1.0) s[count++] = root;
  if (count == 2 && s[0] > s[1]) std::swap(s[0], s[1]);
  return static_cast<int>(count);
}

}  // namespace isolux::volume
