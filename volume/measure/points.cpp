#include "volume/measure/points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace isolux::volume {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kOnALine = 1e-9;  // sine of the angle below which points are on a line

// The value of a function of points, and its error, by central differences.
template <std::size_t N, class Function>
Measured propagated(const std::array<UncertainPoint, N>& points, double size, const Function& function) {
  std::array<glm::dvec3, N> at;
  for (std::size_t i = 0; i < N; ++i) at[i] = points[i].world;
  Measured result{function(at), 0.0};
  const double step = 1e-5 * size;
  for (std::size_t i = 0; i < N; ++i) {
    if (points[i].errorMm == 0.0) continue;
    glm::dvec3 slope(0.0);
    for (int axis = 0; axis < 3; ++axis) {
      std::array<glm::dvec3, N> moved = at;
      moved[i][axis] += step;
      const double higher = function(moved);
      moved[i][axis] -= 2.0 * step;
      slope[axis] = (higher - function(moved)) / (2.0 * step);
    }
    result.error += glm::length(slope) * points[i].errorMm;
  }
  return result;
}

double between(glm::dvec3 a, glm::dvec3 b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * kDegrees;
}

bool onALine(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  const glm::dvec3 u = a - b, v = c - b;
  return !(glm::length(glm::cross(u, v)) > kOnALine * glm::length(u) * glm::length(v));
}

double circumradius(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  const double twiceArea = glm::length(glm::cross(b - a, c - a));
  return glm::length(b - a) * glm::length(c - b) * glm::length(a - c) / (2.0 * twiceArea);
}

}  // namespace

Measured straightDistance(const UncertainPoint& a, const UncertainPoint& b) {
  return {glm::length(a.world - b.world), a.errorMm + b.errorMm};
}

std::optional<Measured> angleDegrees(const UncertainPoint& a, const UncertainPoint& b,
                                     const UncertainPoint& c) {
  const double size = std::min({glm::length(a.world - b.world), glm::length(c.world - b.world)});
  if (!(size > 0.0)) return std::nullopt;
  return propagated(std::array{a, b, c}, size,
                    [](const auto& p) { return between(p[0] - p[1], p[2] - p[1]); });
}

std::optional<Measured> lineAngleDegrees(const UncertainPoint& a, const UncertainPoint& b,
                                         const UncertainPoint& c, const UncertainPoint& d) {
  const double size = std::min({glm::length(b.world - a.world), glm::length(d.world - c.world)});
  if (!(size > 0.0)) return std::nullopt;
  return propagated(std::array{a, b, c, d}, size,
                    [](const auto& p) { return between(p[1] - p[0], p[3] - p[2]); });
}

std::optional<Measured> dihedralDegrees(const UncertainPoint& a, const UncertainPoint& b,
                                        const UncertainPoint& c, const UncertainPoint& d) {
  if (onALine(a.world, b.world, c.world) || onALine(b.world, c.world, d.world)) return std::nullopt;
  const double size = std::min(
      {glm::length(a.world - b.world), glm::length(c.world - b.world), glm::length(d.world - c.world)});
  return propagated(std::array{a, b, c, d}, size, [](const auto& p) {
    const glm::dvec3 axis = p[2] - p[1];
    return between(glm::cross(axis, p[0] - p[1]), glm::cross(axis, p[3] - p[1]));
  });
}

std::optional<Circle> circleThrough(const UncertainPoint& a, const UncertainPoint& b,
                                    const UncertainPoint& c) {
  if (onALine(a.world, b.world, c.world)) return std::nullopt;
  const glm::dvec3 u = b.world - a.world, v = c.world - a.world, across = glm::cross(u, v);
  Circle circle;
  circle.normal = glm::normalize(across);
  circle.centre =
      a.world + (glm::dot(u, u) * glm::cross(v, across) + glm::dot(v, v) * glm::cross(across, u)) /
                    (2.0 * glm::dot(across, across));
  const double size = std::min({glm::length(u), glm::length(v), glm::length(u - v)});
  circle.radiusMm =
      propagated(std::array{a, b, c}, size, [](const auto& p) { return circumradius(p[0], p[1], p[2]); });
  return circle;
}

}  // namespace isolux::volume
