#include "volume/prepared/first_view.h"

#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace isolux::volume {
namespace {

using scene::WorldAxes;

// Of a unit ball, each moved and turned as a shape wants it.
std::vector<OutlineSample> shaped(const std::function<OutlineSample(glm::dvec3)>& shape) {
  constexpr int count = 40000;
  std::vector<OutlineSample> points;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count, angle = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
    const double across = std::sqrt(1.0 - z * z);
    points.push_back(shape({across * std::cos(angle), across * std::sin(angle), z}));
  }
  return points;
}

OutlineSample ofBall(glm::dvec3 p) {
  return {p, p};
}

// An ellipsoid with these half axes.
std::vector<OutlineSample> ellipsoid(glm::dvec3 half) {
  return shaped([&](glm::dvec3 p) { return OutlineSample{half * p, glm::normalize(p / half)}; });
}

// A ball that stands on a cut toward `down`.
std::vector<OutlineSample> standing(glm::dvec3 down) {
  return shaped([&](glm::dvec3 p) {
    const double depth = glm::dot(p, down);
    return depth < 0.6 ? ofBall(p) : OutlineSample{p - (depth - 0.6) * down, down};
  });
}

double degreesAbove(const FirstView& view) {
  return std::asin(glm::dot(view.toEye, view.up)) * 180.0 / std::numbers::pi;
}

TEST(FirstView, OfAPatientIsAPortrait) {
  for (const auto& samples : {shaped(ofBall), standing({1, 0, 0}), std::vector<OutlineSample>{}}) {
    const FirstView view = firstView(samples, WorldAxes::anatomical);
    EXPECT_EQ(view.up, glm::dvec3(0, 0, 1));
    EXPECT_NEAR(degreesAbove(view), 7.0, 1e-9);
    EXPECT_NEAR(view.toEye.x, 0.0, 1e-12);
    EXPECT_LT(view.toEye.y, 0.0) << "from the front";
  }
}

TEST(FirstView, OfAnythingElseIsInThreeQuarters) {
  for (const WorldAxes axes : {WorldAxes::zUp, WorldAxes::yUp}) {
    const FirstView view = firstView(shaped(ofBall), axes);
    EXPECT_EQ(view.up, scene::upOf(axes));
    EXPECT_NEAR(degreesAbove(view), 20.0, 1e-9);
    EXPECT_NEAR(glm::length(view.toEye), 1.0, 1e-12);
    const glm::dvec3 side = glm::normalize(view.toEye - glm::dot(view.toEye, view.up) * view.up);
    EXPECT_NEAR(glm::dot(side, scene::frontOf(axes)), std::cos(std::numbers::pi / 6.0), 1e-9);
  }
}

TEST(FirstView, StandsOnItsFlattestSide) {
  for (const glm::dvec3& down : {glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1)}) {
    const FirstView view = firstView(standing(down), WorldAxes::yUp);
    EXPECT_EQ(view.up, -down);
    EXPECT_NEAR(degreesAbove(view), 20.0, 1e-9);
  }
}

TEST(FirstView, OfASlabIsOfItsLargeFace) {
  EXPECT_NEAR(degreesAbove(firstView(ellipsoid({1, 1, 0.1}), WorldAxes::zUp)), 55.0, 1e-9) << "that lies";
  for (const int thin : {0, 1}) {
    glm::dvec3 half(1.0);
    half[thin] = 0.1;
    const FirstView view = firstView(ellipsoid(half), WorldAxes::zUp);
    EXPECT_GT(std::abs(view.toEye[thin]), 0.8) << "that stands, across axis " << thin;
  }
}

TEST(FirstView, IsFromTheSideWithRelief) {
  const auto oneSided = [](double side) {
    return shaped([&](glm::dvec3 p) {
      if (p.y * side < 0.2) return ofBall(p);
      const glm::dvec3 bump(std::sin(25.0 * p.x), 0.0, std::sin(25.0 * p.z));
      return OutlineSample{p, glm::normalize(p + 0.8 * bump)};
    });
  };
  EXPECT_LT(firstView(oneSided(-1.0), WorldAxes::zUp).toEye.y, 0.0);
  EXPECT_GT(firstView(oneSided(1.0), WorldAxes::zUp).toEye.y, 0.0) << "which is behind";
}

}  // namespace
}  // namespace isolux::volume
