// The trilinear field along a straight segment through a cell: a cubic, exactly, in Bernstein form.
//
// For what works in double precision. The tracer's kernels (volume/tracer) have the same cubic in single
// precision with steps of their own, scalar ones those of the SIMD lanes; tests compare them with this one.
#pragma once

#include <array>

#include <glm/vec3.hpp>

namespace isolux::volume {

// The field at eight corners, x fastest.
using CellCorners = std::array<double, 8>;

// `local` in [0, 1]^3; exact at the corners.
double trilinear(const CellCorners& corners, const glm::dvec3& local);

// sum of C(3,i) (1-s)^(3-i) s^i b[i], s in [0, 1].
struct BernsteinCubic {
  std::array<double, 4> b;

  // From `from` to `to`, both in [0, 1]^3.
  static BernsteinCubic along(const CellCorners& corners, const glm::dvec3& from, const glm::dvec3& to);

  double operator()(double s) const;
  // Extrema in (0, 1), ascending; how many.
  int extrema(std::array<double, 2>& s) const;
};

}  // namespace isolux::volume
