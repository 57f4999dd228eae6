#include "scene/named_camera.h"

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/error.h"

namespace isolux::scene {
namespace {

void expectNearVector(glm::dvec3 actual, glm::dvec3 expected, double tolerance = 1e-9) {
  EXPECT_LE(glm::length(actual - expected), tolerance)
      << actual.x << ' ' << actual.y << ' ' << actual.z << " instead of " << expected.x << ' ' << expected.y
      << ' ' << expected.z;
}

Camera fromTheFront() {
  Camera camera;
  camera.eye = glm::dvec3(5, -100, 7);
  camera.target = glm::dvec3(5, 0, 7);
  camera.up = glm::dvec3(0, 0, 1);
  return camera;
}

TEST(NamedCamera, SidesAndAxesNameTheViewsOfTheKeys) {
  const WorldAxes patient = WorldAxes::anatomical;
  EXPECT_EQ(standardViewNamed("left", patient), StandardView::left);
  EXPECT_EQ(standardViewNamed("Posterior", patient), StandardView::posterior);
  // LPS: +x is the patient's left, +y posterior, +z superior.
  EXPECT_EQ(standardViewNamed("+x", patient), StandardView::left);
  EXPECT_EQ(standardViewNamed("-X", patient), StandardView::right);
  EXPECT_EQ(standardViewNamed("-y", patient), StandardView::anterior);
  EXPECT_EQ(standardViewNamed("y", patient), StandardView::posterior);
  EXPECT_EQ(standardViewNamed("+z", patient), StandardView::superior);
  EXPECT_EQ(standardViewNamed("-z", patient), StandardView::inferior);
  // A mesh: +y is up, and its front looks to +z.
  EXPECT_EQ(standardViewNamed("+y", WorldAxes::yUp), StandardView::superior);
}

TEST(NamedCamera, EveryAxisStandsWhereItSays) {
  const std::array<std::pair<const char*, glm::dvec3>, 6> ends{{{"+x", {1, 0, 0}},
                                                                {"-x", {-1, 0, 0}},
                                                                {"+y", {0, 1, 0}},
                                                                {"-y", {0, -1, 0}},
                                                                {"+z", {0, 0, 1}},
                                                                {"-z", {0, 0, -1}}}};
  for (const WorldAxes axes : {WorldAxes::anatomical, WorldAxes::zUp, WorldAxes::yUp})
    for (const auto& [name, direction] : ends) {
      const Camera camera = standardView({}, standardViewNamed(name, axes), axes, {-3, -2, -1}, {5, 6, 7});
      expectNearVector(glm::normalize(*camera.eye - *camera.target), direction);
    }
}

TEST(NamedCamera, OtherNamesAreRefusedWithTheNearest) {
  for (const char* name : {"", "lefft", "+w", "--x", "xx", "+", "top"}) {
    try {
      standardViewNamed(name, WorldAxes::anatomical);
      ADD_FAILURE() << name;
    } catch (const base::Error& error) {
      EXPECT_EQ(error.kind(), base::ErrorKind::usage);
      if (std::string_view(name) == "lefft") {
        EXPECT_NE(error.reason().find("did you mean left"), std::string::npos);
      }
    }
  }
}

TEST(NamedCamera, AzimuthTakesTheEyeToItsRightAndElevationUp) {
  const Camera camera = fromTheFront();
  // Who looks along +y has +x at the right.
  const Camera right = turned(camera, 90.0, 0.0);
  expectNearVector(*right.eye, {105, 0, 7});
  expectNearVector(*right.up, {0, 0, 1});
  expectNearVector(*turned(camera, 0.0, 90.0).eye, {5, 0, 107});
  expectNearVector(*turned(camera, 30.0, 0.0).eye, {5 + 100 * 0.5, -100 * std::sqrt(0.75), 7});
  // First azimuth, then elevation about what is the right then.
  const Camera both = turned(camera, 90.0, 45.0);
  expectNearVector(*both.eye, {5 + 100 * std::sqrt(0.5), 0, 7 + 100 * std::sqrt(0.5)});
  expectNearVector(*both.target, *camera.target);
}

TEST(NamedCamera, AzimuthKeepsTheHorizonOfACameraThatLooksDown) {
  Camera camera = fromTheFront();
  camera.eye = glm::dvec3(5, -80, 67);
  const Camera after = turned(camera, 120.0, 0.0);
  EXPECT_NEAR(after.eye->z, 67.0, 1e-9);
  EXPECT_NEAR(frameOf(after).right.z, 0.0, 1e-12);
  expectNearVector(*turned(after, 240.0, 0.0).eye, *camera.eye);
}

TEST(NamedCamera, NothingTurnsByWhatIsNoAngle) {
  const Camera camera = fromTheFront();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(turned(camera, 0.0, 0.0), camera);
  EXPECT_EQ(turnedAbout(camera, {0, 0, 1}, nan), camera);
  EXPECT_EQ(turnedAbout(camera, {0, 0, 0}, 10.0), camera);
}

}  // namespace
}  // namespace isolux::scene
