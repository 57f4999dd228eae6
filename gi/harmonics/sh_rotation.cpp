#include "gi/harmonics/sh_rotation.h"

#include <array>
#include <cassert>
#include <cmath>

#include <glm/geometric.hpp>

namespace isolux::gi {

ShRotation::ShRotation(int order, const glm::dmat3& rotation) : order_(order) {
  assert(order >= 1 && order <= maxShOrder);
  elements_.resize(offset(order));
  elements_[0] = 1.0;
  if (order == 1) return;
  glm::dmat3 r;
  r[0] = glm::normalize(rotation[0]);
  r[1] = glm::normalize(rotation[1] - glm::dot(rotation[1], r[0]) * r[0]);
  r[2] = glm::cross(r[0], r[1]);
  assert(glm::dot(r[2], rotation[2]) > 0.0);
  // Band 1 is (y, z, x).
  constexpr std::array<int, 3> axis{1, 2, 0};
  for (int s = -1; s <= 1; ++s)
    for (int t = -1; t <= 1; ++t) element(1, s, t) = r[axis[t + 1]][axis[s + 1]];
  for (int l = 2; l < order; ++l) fillBand(l);
}

// Table 2 of the 1996 paper: iP_{a,b} of band l.
double ShRotation::p(int i, int a, int b, int l) const {
  if (b == l)
    return element(1, i, 1) * element(l - 1, a, l - 1) - element(1, i, -1) * element(l - 1, a, 1 - l);
  if (b == -l)
    return element(1, i, 1) * element(l - 1, a, 1 - l) + element(1, i, -1) * element(l - 1, a, l - 1);
  return element(1, i, 0) * element(l - 1, a, b);
}

// Table 1 (u, v, w) and Table 2 (U, V, W) with the corrections of 1998. A factor of 0 stands where the
// function would read outside the band below.
void ShRotation::fillBand(int l) {
  for (int s = -l; s <= l; ++s)
    for (int t = -l; t <= l; ++t) {
      const int absolute = std::abs(s);
      const double denominator =
          std::abs(t) == l ? 2.0 * l * (2.0 * l - 1.0) : static_cast<double>((l + t) * (l - t));
      double value = 0.0;
      if (absolute < l) value += std::sqrt((l + s) * (l - s) / denominator) * p(0, s, t, l);
      const double v = 0.5 * std::sqrt((l + absolute - 1.0) * (l + absolute) / denominator);
      if (s == 0)
        value -= std::sqrt(2.0) * v * (p(1, 1, t, l) + p(-1, -1, t, l));
      else if (s == 1)
        value += v * std::sqrt(2.0) * p(1, 0, t, l);
      else if (s == -1)
        value += v * std::sqrt(2.0) * p(-1, 0, t, l);
      else if (s > 0)
        value += v * (p(1, s - 1, t, l) - p(-1, 1 - s, t, l));
      else
        value += v * (p(1, s + 1, t, l) + p(-1, -s - 1, t, l));
      const double w = -0.5 * std::sqrt((l - absolute - 1.0) * (l - absolute) / denominator);
      if (s != 0 && absolute < l - 1)
        value +=
            w * (s > 0 ? p(1, s + 1, t, l) + p(-1, -s - 1, t, l) : p(1, s - 1, t, l) - p(-1, 1 - s, t, l));
      element(l, s, t) = value;
    }
}

void ShRotation::apply(std::span<const glm::dvec3> in, std::span<glm::dvec3> out) const {
  assert(in.size() >= static_cast<std::size_t>(shTerms(order_)));
  assert(out.size() >= static_cast<std::size_t>(shTerms(order_)));
  std::array<glm::dvec3, 2 * maxShOrder - 1> band;
  for (int l = 0; l < order_; ++l) {
    const int middle = l * (l + 1);
    for (int s = -l; s <= l; ++s) {
      glm::dvec3 sum(0.0);
      for (int t = -l; t <= l; ++t) sum += element(l, s, t) * in[middle + t];
      band[s + l] = sum;
    }
    for (int s = -l; s <= l; ++s) out[middle + s] = band[s + l];
  }
}

}  // namespace isolux::gi
