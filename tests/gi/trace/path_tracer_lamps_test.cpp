// Light of lamps, against closed forms.
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "tests/gi/light_fixture.h"

namespace isolux::gi {
namespace {

using namespace isolux::test;
using scene::LampKind;
using volume::GridGeometry;

using std::numbers::pi;

constexpr double ballRadius = 7.0, ballHeight = 4.0;

// Inside is z < -10, and a ball above the origin.
std::shared_ptr<const volume::PreparedVolume> planeAndBall() {
  return volumeOf(cube(56), [](glm::dvec3 p) {
    return std::max(-10.0 - p.z, ballRadius - glm::length(p - glm::dvec3(0.0, 0.0, ballHeight)));
  });
}

std::shared_ptr<const volume::PreparedVolume> plane() {
  return volumeOf(cube(24), [](glm::dvec3 p) { return -p.z; });
}

LampLight pointLamp(glm::dvec3 position, double intensity) {
  LampLight lamp;
  lamp.positionMm = position;
  lamp.power = glm::dvec3(intensity);
  return lamp;
}

LampLight sphereLamp(glm::dvec3 centre, double radius, double radiance) {
  LampLight lamp = pointLamp(centre, radiance);
  lamp.kind = LampKind::sphere;
  lamp.radiusMm = radius;
  return lamp;
}

LampLight distantLamp(glm::dvec3 toward, double power, double halfAngle = 0.0) {
  LampLight lamp;
  lamp.kind = LampKind::directional;
  lamp.toward = glm::normalize(toward);
  lamp.cosHalfAngle = std::cos(halfAngle);
  lamp.power = glm::dvec3(power);
  return lamp;
}

// The shadow of a ball of radius R whose centre is at distance h below the lamp, on a plane at distance H:
// tangents reach it at H tan(asin(R / h)).
TEST(PathTracerLamps, APointLampCastsTheShadowOfABall) {
  LightScene light = lightSceneOf(planeAndBall());
  const double lampHeight = 40.0, intensity = 900.0;
  light.lamps = {pointLamp({0.0, 0.0, lampHeight}, intensity)};
  const PathTracer tracer = tracerOf(std::move(light));
  const double reach = (lampHeight + 9.9) * std::tan(std::asin(ballRadius / (lampHeight - ballHeight)));
  for (const double angle : {0.3, 1.7, 4.4}) {
    const glm::dvec2 out(std::cos(angle), std::sin(angle));
    const Estimate dark =
        estimate(tracer, LightPart::lamps, pointAt(tracer, glm::dvec3(0.98 * reach * out, -10.0)), 4);
    EXPECT_EQ(dark.luminance, 0.0);
    const double r = 1.02 * reach, d2 = r * r + 50.0 * 50.0;
    const Estimate lit = estimate(tracer, LightPart::lamps, pointAt(tracer, glm::dvec3(r * out, -10.0)), 4);
    EXPECT_NEAR(lit.luminance, intensity * 50.0 / std::pow(d2, 1.5), 2e-6);
    EXPECT_EQ(lit.standardError, 0.0);
    EXPECT_EQ(lit.rays, 1u);  // not one a sample
  }
}

TEST(PathTracerLamps, ADistantLampCastsTheShadowOfABall) {
  LightScene light = lightSceneOf(planeAndBall());
  const glm::dvec3 toward = glm::normalize(glm::dvec3(0.3, 0.2, 1.0));
  light.lamps = {distantLamp(toward, 2.5)};
  const PathTracer tracer = tracerOf(std::move(light));
  // The shadow's middle on the plane, and its reach across the light.
  const glm::dvec3 middle = glm::dvec3(0.0, 0.0, ballHeight) - toward * ((ballHeight + 9.9) / toward.z);
  const glm::dvec3 across = glm::normalize(glm::dvec3(-toward.y, toward.x, 0.0));
  const auto at = [&](double radii) {
    const glm::dvec3 p = middle + radii * ballRadius * across;
    return estimate(tracer, LightPart::lamps, pointAt(tracer, {p.x, p.y, -10.0}), 4).luminance;
  };
  EXPECT_EQ(at(0.0), 0.0);
  EXPECT_EQ(at(0.98), 0.0);
  EXPECT_NEAR(at(1.02), 2.5 * toward.z, 1e-5);
  EXPECT_NEAR(at(-1.02), 2.5 * toward.z, 1e-5);
}

TEST(PathTracerLamps, LampsBelowTheHorizonGiveNothing) {
  LightScene light = lightSceneOf(plane());
  light.lamps = {pointLamp({1.0, 0.0, -3.0}, 9.0), distantLamp({0.2, 0.1, -1.0}, 3.0),
                 distantLamp({0.2, 0.1, -1.0}, 3.0, 0.2), sphereLamp({0.0, 0.0, -9.0}, 3.0, 5.0)};
  light.bounces = 2;
  const PathTracer tracer = tracerOf(std::move(light));
  EXPECT_EQ(estimate(tracer, LightPart::lamps, pointAt(tracer, glm::dvec3(0.0)), 200).luminance, 0.0);
}

// E = pi L (R / d)^2 cos for a sphere that is wholly above the horizon, at any distance.
TEST(PathTracerLamps, ASphereLampGivesItsFormFactorNearAndFar) {
  for (const double distance : {3.01, 4.0, 10.0, 1e3, 1e6}) {
    for (const double tilt : {0.0, 0.25}) {
      const double radius = 3.0;
      const glm::dvec3 centre = distance * glm::dvec3(std::sin(tilt), 0.0, std::cos(tilt));
      if (centre.z < radius) continue;
      LightScene light = lightSceneOf(plane());
      light.lamps = {sphereLamp(centre, radius, 2.0)};
      const PathTracer tracer = tracerOf(std::move(light));
      const double expected = pi * 2.0 * radius * radius / (distance * distance) * std::cos(tilt);
      EXPECT_TRUE(
          agrees(estimate(tracer, LightPart::lamps, pointAt(tracer, glm::dvec3(0.0)), 4000), expected))
          << distance << ' ' << tilt;
    }
  }
}

// A sphere that the horizon cuts, against the integral over its cone in rings; the rings' part above the
// horizon is known.
TEST(PathTracerLamps, TheHorizonCutsASphereLamp) {
  const double sine = 0.6, alpha = std::asin(sine), elevation = 0.2;  // of the centre, above the horizon
  LightScene light = lightSceneOf(plane());
  light.lamps = {
      sphereLamp(10.0 * glm::dvec3(std::cos(elevation), 0.0, std::sin(elevation)), 10.0 * sine, 1.0)};
  const PathTracer tracer = tracerOf(std::move(light));
  double expected = 0.0;
  constexpr int rings = 4000;
  for (int i = 0; i < rings; ++i) {  // at angle `a` from the axis: z = p + q cos phi
    const double a = (i + 0.5) / rings * alpha;
    const double p = std::sin(elevation) * std::cos(a), q = std::cos(elevation) * std::sin(a);
    const double half = p >= q ? pi : p <= -q ? 0.0 : std::acos(-p / q);
    expected += 2.0 * (p * half + q * std::sin(half)) * std::sin(a) * alpha / rings;
  }
  EXPECT_TRUE(agrees(estimate(tracer, LightPart::lamps, pointAt(tracer, glm::dvec3(0.0)), 40000), expected));
}

TEST(PathTracerLamps, InsideASphereLampLightComesFromEverywhere) {
  LightScene light = lightSceneOf(plane());
  light.lamps = {sphereLamp({0.5, 0.0, 0.5}, 4.0, 2.0)};
  const PathTracer tracer = tracerOf(std::move(light));
  EXPECT_TRUE(agrees(estimate(tracer, LightPart::lamps, pointAt(tracer, glm::dvec3(0.0)), 400), 2.0 * pi));
}

// E = pi L sin^2(alpha) cos of a disc of directions above the horizon.
TEST(PathTracerLamps, ADistantDiscGivesItsFormFactor) {
  for (const double halfAngle : {1e-4, 0.1, 0.7}) {
    const double tilt = 0.5;
    LightScene light = lightSceneOf(plane());
    light.lamps = {distantLamp({std::sin(tilt), 0.0, std::cos(tilt)}, 2.0, halfAngle)};
    const PathTracer tracer = tracerOf(std::move(light));
    const double sine = std::sin(halfAngle);
    EXPECT_TRUE(agrees(estimate(tracer, LightPart::lamps, pointAt(tracer, glm::dvec3(0.0)), 4000),
                       pi * 2.0 * sine * sine * std::cos(tilt)))
        << halfAngle;
  }
}

// A ball in front of a sphere lamp that it hides wholly, and one that is too far aside.
TEST(PathTracerLamps, ABallHidesASphereLamp) {
  LightScene light = lightSceneOf(planeAndBall());
  light.lamps = {sphereLamp({0.0, 0.0, 45.0}, 6.0, 3.0)};
  const PathTracer tracer = tracerOf(std::move(light));
  EXPECT_EQ(estimate(tracer, LightPart::lamps, pointAt(tracer, {0.3, 0.0, -10.0}), 400).luminance, 0.0);
  const glm::dvec3 aside(24.0, 0.0, -10.0);
  const glm::dvec3 toward = glm::dvec3(0.0, 0.0, 45.0) - aside;
  const double d = glm::length(toward);
  EXPECT_TRUE(agrees(estimate(tracer, LightPart::lamps, pointAt(tracer, aside), 4000),
                     pi * 3.0 * 36.0 / (d * d) * toward.z / d));
}

TEST(PathTracerLamps, LampsAddUp) {
  LightScene light = lightSceneOf(planeAndBall());
  light.bounces = 3;
  const std::vector<LampLight> lamps = {pointLamp({15.0, 3.0, 20.0}, 300.0),
                                        distantLamp({-0.6, 0.1, 0.7}, 1.5),
                                        sphereLamp({0.0, -20.0, 15.0}, 4.0, 3.0)};
  const glm::dvec3 at(8.0, -5.0, -10.0);
  Estimate sum;
  for (const LampLight& lamp : lamps) {
    light.lamps = {lamp};
    const PathTracer tracer = tracerOf(light);
    const Estimate e = estimate(tracer, LightPart::lamps, pointAt(tracer, at), 20000);
    sum.luminance += e.luminance;
    sum.standardError = std::hypot(sum.standardError, e.standardError);
  }
  light.lamps = lamps;
  const PathTracer tracer = tracerOf(light);
  EXPECT_TRUE(agree(estimate(tracer, LightPart::lamps, pointAt(tracer, at, 5), 20000), sum));
}

TEST(PathTracerLamps, ALampAtThePointItselfIsFinite) {
  LightScene light = lightSceneOf(plane());
  light.lamps = {pointLamp(glm::dvec3(0.0), 1.0), sphereLamp(glm::dvec3(0.0), 1e-9, 1.0)};
  light.bounces = 1;
  const PathTracer tracer = tracerOf(std::move(light));
  for (const double z : {0.0, 1e-9, 1e-4}) {
    const double e = estimate(tracer, LightPart::lamps, pointAt(tracer, {0.0, 0.0, -z}), 16).luminance;
    EXPECT_TRUE(std::isfinite(e)) << z;
  }
}

}  // namespace
}  // namespace isolux::gi
