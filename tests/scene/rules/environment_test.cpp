#include "scene/rules/environment.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <glm/ext/quaternion_double.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace isolux::scene {
namespace {

glm::dvec3 toWorld(const Environment& environment, WorldAxes axes, const glm::dvec3& v) {
  const glm::dvec4 q = glm::normalize(rotationOf(environment, axes));
  return glm::dquat(q.x, q.y, q.z, q.w) * v;
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_LT(glm::distance(a, b), 1e-12) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(EnvironmentKind, AFileComesBeforeAColourAndThatBeforeABuiltInLight) {
  Environment environment;
  EXPECT_EQ(kindOf(environment), EnvironmentKind::builtIn);
  environment.constant = glm::dvec3(1.0);
  EXPECT_EQ(kindOf(environment), EnvironmentKind::oneColor);
  EXPECT_TRUE(hasOneColor(environment));
  environment.file = "probe.hdr";
  EXPECT_EQ(kindOf(environment), EnvironmentKind::file);
  EXPECT_FALSE(hasOneColor(environment));
  environment.azimuth = 30.0;
  chooseBuiltIn(environment, BuiltInLight::sunset);
  EXPECT_EQ(kindOf(environment), EnvironmentKind::builtIn);
  EXPECT_EQ(environment.builtIn, BuiltInLight::sunset);
  EXPECT_EQ(environment.azimuth, 30.0);
}

TEST(EnvironmentRotation, TheQuaternionAloneIsLeftAsItIs) {
  Environment environment;
  environment.rotation = {0.1, -0.7, 2.0, 1e-9};
  for (const WorldAxes axes : {WorldAxes::anatomical, WorldAxes::zUp})
    EXPECT_EQ(rotationOf(environment, axes), environment.rotation);
  environment.file = "probe.hdr";
  EXPECT_EQ(rotationOf(environment, WorldAxes::yUp), environment.rotation);
}

TEST(EnvironmentRotation, AzimuthAndElevationAreTheQuaternionTheyStandFor) {
  const double eighth = 0.125 * 3.14159265358979323846;  // half of 45 degrees
  for (const char* const file : {"", "probe.hdr"}) {
    Environment turned, raised, both;
    turned.file = raised.file = both.file = file;
    turned.azimuth = both.azimuth = raised.elevation = both.elevation = 45.0;
    const glm::dvec4 aboutZ(std::cos(eighth), 0.0, 0.0, std::sin(eighth));
    const glm::dvec4 aboutX(std::cos(eighth), -std::sin(eighth), 0.0, 0.0);
    EXPECT_LT(glm::distance(rotationOf(turned, WorldAxes::anatomical), aboutZ), 1e-12);
    EXPECT_LT(glm::distance(rotationOf(raised, WorldAxes::anatomical), aboutX), 1e-12);
    const glm::dquat z(aboutZ.x, aboutZ.y, aboutZ.z, aboutZ.w), x(aboutX.x, aboutX.y, aboutX.z, aboutX.w);
    const glm::dquat product = z * x;
    EXPECT_LT(glm::distance(rotationOf(both, WorldAxes::anatomical),
                            glm::dvec4(product.w, product.x, product.y, product.z)),
              1e-12);
  }
}

TEST(EnvironmentRotation, LightFromTheFrontIsRaisedAndThenTurnedCounterclockwise) {
  const glm::dvec3 front(0.0, -1.0, 0.0);
  Environment environment;
  environment.elevation = 30.0;
  expectNear(toWorld(environment, WorldAxes::zUp, front), {0.0, -std::sqrt(0.75), 0.5});
  environment.azimuth = 90.0;
  expectNear(toWorld(environment, WorldAxes::zUp, front), {std::sqrt(0.75), 0.0, 0.5});
  environment.rotation = {0.0, 0.0, 0.0, 1.0};  // half a turn about the vertical comes first
  expectNear(toWorld(environment, WorldAxes::zUp, -front), {std::sqrt(0.75), 0.0, 0.5});
}

TEST(EnvironmentRotation, BuiltInLightsStandByWhatIsUpAndInFront) {
  Environment environment;
  expectNear(toWorld(environment, WorldAxes::yUp, {0.0, 0.0, 1.0}), upOf(WorldAxes::yUp));
  expectNear(toWorld(environment, WorldAxes::yUp, {0.0, -1.0, 0.0}), frontOf(WorldAxes::yUp));
  expectNear(toWorld(environment, WorldAxes::yUp, {1.0, 0.0, 0.0}), {1.0, 0.0, 0.0});
  environment.azimuth = 90.0;
  expectNear(toWorld(environment, WorldAxes::yUp, {0.0, 0.0, 1.0}), upOf(WorldAxes::yUp));
  expectNear(toWorld(environment, WorldAxes::yUp, {0.0, -1.0, 0.0}), {1.0, 0.0, 0.0});
}

TEST(EnvironmentRotation, ARotationThatIsSetIsTheWholeOne) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (const WorldAxes axes : {WorldAxes::anatomical, WorldAxes::yUp})
    for (const char* const file : {"", "probe.hdr"}) {
      Environment environment;
      environment.file = file;
      environment.azimuth = 200.0 * number(random);
      environment.elevation = 80.0 * number(random);
      const glm::dvec4 wanted =
          glm::normalize(glm::dvec4(number(random), number(random), number(random), number(random)));
      const double azimuth = environment.azimuth;
      setRotation(environment, wanted, axes);
      const glm::dvec4 found = rotationOf(environment, axes);
      EXPECT_NEAR(std::abs(glm::dot(wanted, found)), 1.0, 1e-12);
      EXPECT_EQ(environment.azimuth, azimuth);
    }
}

}  // namespace
}  // namespace isolux::scene
