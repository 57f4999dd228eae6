// Distances, angles and circles of given points, with what the uncertainty of their positions makes of them.
//
// World mm, angles in degrees. Any thread.
#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "volume/measure/measured.h"

namespace isolux::volume {

// A position and how far it may be wrong in any direction, mm.
struct UncertainPoint {
  glm::dvec3 world{0.0};
  double errorMm = 0.0;
};

// Errors are sums of |derivative by a point's position| * that point's error.
Measured straightDistance(const UncertainPoint& a, const UncertainPoint& b);
// At b, between a and c, 0 to 180; nothing where two points coincide.
std::optional<Measured> angleDegrees(const UncertainPoint& a, const UncertainPoint& b,
                                     const UncertainPoint& c);
// Between the planes a b c and b c d, about the axis b c: 0 where a and d lie on the same side, 180 where
// opposite; nothing where three points lie on a line.
std::optional<Measured> dihedralDegrees(const UncertainPoint& a, const UncertainPoint& b,
                                        const UncertainPoint& c, const UncertainPoint& d);
// Between the directions from a to b and from c to d, wherever they lie, 0 to 180; nothing where two points
// of a direction coincide.
std::optional<Measured> lineAngleDegrees(const UncertainPoint& a, const UncertainPoint& b,
                                         const UncertainPoint& c, const UncertainPoint& d);

struct Circle {
  glm::dvec3 centre{0.0}, normal{0.0};
  Measured radiusMm;
};
// Through three points; nothing where they lie on a line.
std::optional<Circle> circleThrough(const UncertainPoint& a, const UncertainPoint& b,
                                    const UncertainPoint& c);

}  // namespace isolux::volume
