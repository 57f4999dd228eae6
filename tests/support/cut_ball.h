// A hollow ball that the volume's border cuts open: light of its two sides in closed form.
//
// Under a sky of radiance 1 the outer side, convex, has E = pi. A sphere's form factor between any of its
// points and any part of it is that part's share of its area, and what lies behind the opening is the cap
// that is cut off: every point of the inner side sees the part height / (2 radius) of the sky, and what is
// left of the sphere for the rest. So E = pi visibility (1 + albedo (1 - visibility) + ...), a term a bounce.
#pragma once

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "tests/support/volumes.h"

namespace isolux::test {

struct CutBall {
  glm::dvec3 middle{18.0, 18.0, 16.0};  // mm; voxels of 1 mm
  glm::ivec3 dims{37, 37, 24};          // the last slice cuts the cap off
  double radius = 14.0;
  double isovalue = 0.0;

  double visibility() const { return (middle.z + radius - (dims.z - 1)) / (2.0 * radius); }
  double innerIrradiance(double albedo, int bounces) const {
    double sum = 0.0;
    for (int bounce = 0; bounce <= bounces; ++bounce) sum += std::pow(albedo * (1.0 - visibility()), bounce);
    return std::numbers::pi * visibility() * sum;
  }
  // Above 0 inside; `sign` -1: below.
  std::shared_ptr<const volume::PreparedVolume> volume(double sign = 1.0) const {
    return prepared(gridOfWorld(unitGeometry(dims),
                                [&](glm::dvec3 p) { return sign * (radius - glm::length(p - middle)); }));
  }
};

}  // namespace isolux::test
