// Rotates spherical-harmonic coefficients (Ivanic & Ruedenberg, J. Phys. Chem. 100, 1996, 6342, with the
// corrections of J. Phys. Chem. A 102, 1998, 9099; Wyman et al. 2006 eq. 17, whose Table 3 is garbled).
//
// apply() returns the coefficients of g(d) = f(R^T d): the value of f in direction d is that of g in R d.
// Bands do not mix. Constructing takes a few microseconds per rotation at order 5. Immutable; safe from any
// thread.
#pragma once

#include <span>
#include <vector>

#include <glm/mat3x3.hpp>

#include "gi/harmonics/spherical_harmonics.h"

namespace isolux::gi {

class ShRotation {
 public:
  // Requires a proper rotation up to rounding. It is orthonormalised first, so products of many rotations are
  // allowed.
  ShRotation(int order, const glm::dmat3& rotation);

  // Rotates spans of at least order^2 values; `in` and `out` are the same or do not overlap.
  void apply(std::span<const glm::dvec3> in, std::span<glm::dvec3> out) const;

  // Returns the element in row s, column t of band l's matrix, -l <= s, t <= l.
  double element(int l, int s, int t) const { return elements_[offset(l) + (s + l) * (2 * l + 1) + t + l]; }

 private:
  static int offset(int l) { return l * (2 * l - 1) * (2 * l + 1) / 3; }  // sum of (2k + 1)^2 for k < l
  double& element(int l, int s, int t) { return elements_[offset(l) + (s + l) * (2 * l + 1) + t + l]; }
  double p(int i, int a, int b, int l) const;
  void fillBand(int l);

  int order_;
  std::vector<double> elements_;
};

}  // namespace isolux::gi
