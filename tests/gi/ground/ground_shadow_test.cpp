// The shadow on the ground against closed forms.
#include "gi/ground/ground_shadow.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "scene/opacity.h"
#include "scene/rules/automatic.h"
#include "tests/gi/light_fixture.h"
#include "tests/support/lamps.h"

namespace isolux::test {
namespace {

constexpr double kRadius = 12.0;  // mm
constexpr int kSize = 33;

// A ball about the world's origin: the ground is z = -kRadius, and its borders are 3 radii from the middle.
class GroundShadowTest : public ::testing::Test {
 protected:
  GroundShadowTest() {
    scene_.look.mode = scene::LookMode::gi;
    scene_.surfaces.front().value = 0.0;
    scene_.gi.ground = true;
    scene_.light.environment.constant = glm::dvec3(0.7);
  }

  std::shared_ptr<const gi::GroundShadow> make(
      const std::shared_ptr<const gi::GroundShadow>& before = nullptr) {
    base::Progress progress;
    const scene::Scene resolved = scene::resolve(scene_, volume_->facts);
    const auto light = gi::makeLightScene(resolved, volume_, gi::lightTracerOf(resolved, volume_, progress),
                                          gi::loadEnvironment(resolved.light.environment));
    return gi::makeGroundShadow(resolved, *light, before, progress);
  }

  // Fraction of a uniform sky that the ball hides at `d` mm from where it touches the ground: its form
  // factor.
  static double hidden(double d) {
    const double distance = std::hypot(d, kRadius);
    return std::pow(kRadius / distance, 2) * kRadius / distance;
  }
  static glm::dvec2 placeAt(const gi::GroundShadow& ground, double d, double angle) {
    return d / glm::length(ground.rightMm) * glm::dvec2(std::cos(angle), std::sin(angle));
  }

  std::shared_ptr<const volume::PreparedVolume> volume_ =
      volumeOf(cube(kSize), [](glm::dvec3 p) { return kRadius - glm::length(p); });
  scene::Scene scene_;
};

TEST_F(GroundShadowTest, TouchesTheLowestPoint) {
  const auto ground = make();
  ASSERT_TRUE(ground);
  EXPECT_LT(glm::length(ground->middleMm - glm::dvec3(0.0, 0.0, -kRadius)), 1e-6);
  EXPECT_NEAR(glm::length(ground->rightMm), 3.0 * kRadius, 1e-6);
  EXPECT_NEAR(glm::length(ground->backMm), 3.0 * kRadius, 1e-6);
}

TEST_F(GroundShadowTest, OfABallUnderAUniformSkyIsItsFormFactor) {
  const auto ground = make();
  for (double d = 0.5; d < 3.0 * kRadius * gi::GroundShadow::kFadesFrom; d += 1.7)
    for (const double angle : {0.3, 2.0, 4.4})
      EXPECT_NEAR(1.0 - static_cast<double>(ground->at(placeAt(*ground, d, angle))), hidden(d), 0.012) << d;
  EXPECT_LT(ground->at(glm::dvec2(0.0)), 0.01f);
}

TEST_F(GroundShadowTest, FadesToExactlyOneAtTheBorder) {
  const auto ground = make();
  for (int i = 0; i < gi::GroundShadow::kPoints; ++i)
    for (const int edge : {0, gi::GroundShadow::kPoints - 1}) {
      const auto at = [&](int x, int y) {
        return ground->light[static_cast<std::size_t>(y * gi::GroundShadow::kPoints + x)];
      };
      EXPECT_EQ(at(i, edge), 1.0f);
      EXPECT_EQ(at(edge, i), 1.0f);
    }
  EXPECT_EQ(ground->at({0.8, 0.7}), 1.0f);
  EXPECT_EQ(ground->at({1.5, 0.0}), 1.0f);
}

// A surface that lets half of the light through casts half of the shadow.
TEST_F(GroundShadowTest, OfATransparentSurfaceIsLighter) {
  const auto opaque = make();
  scene_.surfaces.front().opacity = 0.5;
  const auto half = make();
  for (const double d : {2.0, 9.0, 15.0}) {
    const glm::dvec2 place = placeAt(*opaque, d, 1.0);
    EXPECT_NEAR(1.0f - half->at(place),
                static_cast<float>(scene::meanOpacity(0.5, 1.0)) * (1.0f - opaque->at(place)), 0.005f);
  }
}

// The shadow of a point light: the ball's outline seen from the light, on the ground.
TEST_F(GroundShadowTest, OfAPointLightHasAnEdge) {
  scene_.light.environment.constant = glm::dvec3(0.0);
  test::lampAt(scene_, 0).shown = true;
  test::lampAt(scene_, 0).kind = scene::LampKind::point;
  test::lampAt(scene_, 0).position = glm::dvec3(0.0, 0.0, 6.0 * kRadius);
  const auto ground = make();
  // The tangent from the light touches the ball at the angle asin(1/6) and meets the ground 7 radii below.
  const double edge = 7.0 * kRadius * std::tan(std::asin(1.0 / 6.0));
  for (const double angle : {0.0, 1.0, 2.5}) {
    EXPECT_LT(ground->at(placeAt(*ground, edge - 0.6, angle)), 0.01f);
    EXPECT_EQ(ground->at(placeAt(*ground, edge + 0.6, angle)), 1.0f);
  }
}

// A light from the right casts the shadow to the left.
TEST_F(GroundShadowTest, OfADistantLightFallsToTheOtherSide) {
  scene_.light.environment.constant = glm::dvec3(0.0);
  test::lampAt(scene_, 0).shown = true;
  test::lampAt(scene_, 0).kind = scene::LampKind::directional;
  test::lampAt(scene_, 0).direction = glm::normalize(glm::dvec3(1.0, 0.0, 1.0));
  const auto ground = make();
  const double side = ground->rightMm.x > 0.0 ? -1.0 : 1.0;
  EXPECT_LT(ground->at(side * placeAt(*ground, kRadius, 0.0)),
            0.01f);  // under the ball's middle, at 45 degrees
  EXPECT_EQ(ground->at(-side * placeAt(*ground, kRadius, 0.0)), 1.0f);
}

TEST_F(GroundShadowTest, IsKeptWhileNothingOfItChanges) {
  const auto ground = make();
  scene_.surfaces.front().albedo = glm::dvec3(0.2);
  scene_.gi.samples = 7;
  EXPECT_EQ(make(ground), ground);
  scene_.surfaces.front().value = 1.0;
  const auto smaller = make(ground);
  EXPECT_NE(smaller->key, ground->key);
  EXPECT_NEAR(smaller->middleMm.z, 1.0 - kRadius, 1e-6);
  scene_.surfaces.front().value = 0.0;
  EXPECT_EQ(make(smaller)->light, ground->light);  // the same numbers again
  scene_.surfaces.front().value = 100.0;
  EXPECT_EQ(make(), nullptr);
  scene_.gi.ground = false;
  EXPECT_EQ(make(ground), nullptr);
}

// placesOf() against the rays of the camera.
TEST_F(GroundShadowTest, IsMetByTheRaysOfTheCamera) {
  const auto ground = make();
  scene::Camera camera;
  camera.eye = glm::dvec3(20.0, -70.0, 25.0);
  camera.target = glm::dvec3(3.0, 2.0, -5.0);
  camera.up = glm::dvec3(0.1, 0.2, 1.0);
  for (const auto projection : {scene::Projection::perspective, scene::Projection::orthographic}) {
    camera.projection = projection;
    const scene::CameraFrame frame = scene::frameOf(camera);
    const auto places = ground->placesOf(frame, 1.5);
    ASSERT_TRUE(places);
    for (const glm::dvec2& ndc : {glm::dvec2(0.0), {0.7, -0.3}, {-0.9, -0.8}}) {
      const scene::Ray ray = scene::rayThrough(frame, ndc, 1.5);
      const double t = (-kRadius - ray.origin.z) / ray.direction.z;
      const glm::dvec3 hit = ray.origin + t * ray.direction - ground->middleMm;
      const glm::dvec3 place = *places * glm::dvec3(ndc, 1.0);
      EXPECT_NEAR(place.x / place.z,
                  glm::dot(hit, ground->rightMm) / glm::dot(ground->rightMm, ground->rightMm), 1e-9);
      EXPECT_NEAR(place.y / place.z, glm::dot(hit, ground->backMm) / glm::dot(ground->backMm, ground->backMm),
                  1e-9);
    }
  }
  camera.eye = glm::dvec3(0.0, -70.0, -20.0);
  camera.target = glm::dvec3(0.0);
  for (const auto projection : {scene::Projection::perspective, scene::Projection::orthographic}) {
    camera.projection = projection;
    EXPECT_FALSE(ground->placesOf(scene::frameOf(camera), 1.0));
  }
}

}  // namespace
}  // namespace isolux::test
