// Turning as arithmetic: rotations against closed forms.
#include "app/view_math/turning.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace isolux::app {
namespace {

using std::numbers::pi;

double distance(glm::dvec4 a, glm::dvec4 b) {  // of rotations: q and -q are the same
  a /= glm::length(a);
  b /= glm::length(b);
  return std::min(glm::distance(a, b), glm::distance(a, -b));
}

}  // namespace

TEST(Turning, AnglesSayWhereTheMiddleLooks) {
  const double h = 30.0, e = 20.0;
  const glm::dvec3 middle = rotated(rotationOf({h, e, 77.0}), {0.0, 1.0, 0.0});
  EXPECT_NEAR(middle.x, -std::sin(h * pi / 180.0) * std::cos(e * pi / 180.0), 1e-12);
  EXPECT_NEAR(middle.y, std::cos(h * pi / 180.0) * std::cos(e * pi / 180.0), 1e-12);
  EXPECT_NEAR(middle.z, std::sin(e * pi / 180.0), 1e-12);
}

TEST(Turning, AnglesAndRotationsAreInverse) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(-179.0, 180.0), elevation(-90.0, 90.0);
  for (int i = 0; i < 500; ++i) {
    const glm::dvec4 q = 3.0 * rotationOf({angle(random), elevation(random), angle(random)});
    EXPECT_LT(distance(rotationOf(anglesOf(q)), q), 1e-9);
  }
  for (const double up : {90.0, -90.0}) {
    const TurnAngles angles = anglesOf(rotationOf({25.0, up, 40.0}));
    EXPECT_EQ(angles.elevation, up);
    EXPECT_EQ(angles.roll, 0.0);
    EXPECT_LT(distance(rotationOf(angles), rotationOf({25.0, up, 40.0})), 1e-9);
  }
}

TEST(Turning, QuarterTurnsAreExact) {
  EXPECT_EQ(rotationOf({180.0, 0.0, 0.0}), glm::dvec4(0.0, 0.0, 0.0, 1.0));
  EXPECT_EQ(rotationOf({0.0, 0.0, 0.0}), glm::dvec4(1.0, 0.0, 0.0, 0.0));
  EXPECT_EQ(anglesOf({0.0, 0.0, 0.0, -5.0}).heading, 180.0);
  const TurnAngles none = anglesOf({0.0, 0.0, 0.0, 0.0});
  EXPECT_EQ(none.heading, 0.0);
}

TEST(Turning, TheBallsFrontFollowsThePointer) {
  scene::Camera camera;
  camera.eye = glm::dvec3(60.0, -280.0, 90.0);
  camera.target = glm::dvec3(4.0, 2.0, -3.0);
  camera.up = glm::dvec3(0.1, 0.2, 1.0);
  const scene::CameraFrame frame = scene::frameOf(camera);
  const glm::dvec4 start = rotationOf({35.0, 10.0, -4.0});
  const glm::dvec2 from(0.1, -0.2), to(-0.3, 0.25);
  const auto onBall = [&](glm::dvec2 p) {
    return frame.right * p.x + frame.up * p.y + frame.back * std::sqrt(1.0 - glm::dot(p, p));
  };
  const glm::dvec4 turned = turnedByDrag(start, frame, from, to);
  // What the environment had where the pointer was is now where the pointer is.
  EXPECT_LT(glm::distance(rotated(turned, rotatedBack(start, onBall(from))), onBall(to)), 1e-12);
  EXPECT_LT(distance(turnedByDrag(start, frame, from, from), start), 1e-15);
  const glm::dvec4 far = turnedByDrag(start, frame, {-40.0, 0.0}, {40.0, 0.0});  // beyond the ball
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(std::isfinite(far[i]));
}

}  // namespace isolux::app
