#include "gi/trace/exposure_meter.h"

#include <cmath>

#include <gtest/gtest.h>

#include "scene/rules/automatic.h"
#include "tests/support/lamps.h"
#include "tests/support/volumes.h"

namespace isolux::gi {
namespace {

class ExposureMeter : public ::testing::Test {
 protected:
  ExposureMeter() { scene_.look.mode = scene::LookMode::gi; }

  scene::Scene resolved() const { return scene::resolve(scene_, volume_->facts); }
  std::optional<SurfaceBrightness> measured() const {
    base::Progress progress;
    const auto tracer = std::make_shared<const volume::IsosurfaceTracer>(volume_->volume.grid,
                                                                         scene_.isosurface.inside, progress);
    scene::Scene metered = resolved();
    metered.camera = scene_.camera.eye ? metered.camera : scene::Camera{};
    return measureBrightness(metered, volume_, tracer, loadEnvironment(scene_.light.environment), progress);
  }

  std::shared_ptr<const volume::PreparedVolume> volume_ = test::phantom("ball", 24);
  scene::Scene scene_;
};

// The meter reads what lights a surface, not its colour: one that reflects 0.6 would be as bright as it says.
TEST_F(ExposureMeter, AConvexSurfaceUnderAnEvenSkyReceivesItsRadiance) {
  scene_.light.environment.constant = glm::dvec3(2.0, 2.0, 2.0);
  scene_.light.environment.exposure = 1.0;
  for (const double albedo : {0.25, 0.75}) {
    scene_.surfaces.front().albedo = glm::dvec3(albedo);
    const auto seen = measured();
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->median, 0.6 * 2.0 * 2.0, 5e-3);
    EXPECT_NEAR(seen->highlight, 0.6 * 2.0 * 2.0, 5e-2);
  }
}

// In concave places light is reflected to and fro, which a meter of illuminance takes out but for its limits.
TEST_F(ExposureMeter, TwiceTheAlbedoIsTwiceAsBrightInEveryLight) {
  volume_ = test::phantom("head", 48);
  for (const scene::BuiltInLight light : {scene::BuiltInLight::studio, scene::BuiltInLight::window,
                                          scene::BuiltInLight::overcast, scene::BuiltInLight::sunset}) {
    scene_.light.environment.builtIn = light;
    const auto shown = [&](double albedo) {
      scene_.surfaces.front().albedo = glm::dvec3(albedo);
      const auto seen = measured();
      return seen ? albedo / 0.6 * seen->median * std::exp2(exposureOf(*seen)) : 0.0;
    };
    EXPECT_NEAR(shown(0.8) / shown(0.4), 2.0, 0.1);
  }
}

TEST_F(ExposureMeter, FromBehindTheLightTheViewIsMetered) {
  scene_.light.environment.constant = glm::dvec3(0.0);
  test::lampAt(scene_, 0).shown = true;
  test::lampAt(scene_, 0).kind = scene::LampKind::directional;
  test::lampAt(scene_, 0).direction = glm::dvec3(0.0, -1.0, 0.3);  // from the front, a little above
  const auto front = measured();
  scene_.camera.eye = glm::dvec3(0.0, 30.0, 100.0);  // from above and behind
  scene_.camera.target = glm::dvec3(0.0);
  const auto above = measured();
  ASSERT_TRUE(front && above);
  EXPECT_LT(above->median, 0.5 * front->median);
  scene_.camera.eye = glm::dvec3(0.0);  // from within: no front face is seen
  scene_.camera.target = glm::dvec3(0.0, 1.0, 0.0);
  const auto within = measured();
  ASSERT_TRUE(within);
  EXPECT_EQ(within->median, front->median);
}

TEST_F(ExposureMeter, ALampCountsAsItLights) {
  scene_.light.environment.constant = glm::dvec3(0.0);
  scene_.surfaces.front().albedo = glm::dvec3(0.5);
  scene_.gi.bounces = 0;
  test::lampAt(scene_, 0).shown = true;
  test::lampAt(scene_, 0).kind = scene::LampKind::directional;
  test::lampAt(scene_, 0).direction = glm::dvec3(0.0, -1.0, 0.0);  // from the front
  const auto seen = measured();
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->highlight, 0.6, 0.02);  // faces the lamp: 1, times the reflectance
  EXPECT_LT(seen->median, seen->highlight);
}

TEST_F(ExposureMeter, WhatThePictureIsMadeOfDoesNotEnter) {
  scene::Scene other = resolved();
  other.picture.supersampling = 1;
  other.gi.samples = 7;
  other.gi.interpolation = scene::GiInterpolation::nearest;
  other.light.environment.moves = true;
  EXPECT_EQ(meteredScene(other), meteredScene(resolved()));
  other.surfaces.front().albedo.x *= 0.5;
  EXPECT_NE(meteredScene(other), meteredScene(resolved()));
}

TEST_F(ExposureMeter, IsTheSameEveryTime) {
  const auto a = measured(), b = measured();
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->median, b->median);
  EXPECT_EQ(a->highlight, b->highlight);
}

TEST_F(ExposureMeter, NothingIsSeenWhereThereIsNoSurface) {
  scene_.surfaces.front().value = 1e6;
  EXPECT_FALSE(measured());
}

TEST(Exposure, PutsTheMedianInTheMiddleUnlessHighlightsAskForLess) {
  const auto shown = [](double median, double highlight) {
    const double factor = std::exp2(exposureOf({median, highlight}));
    return std::pair(median * factor, highlight * factor);
  };
  EXPECT_NEAR(shown(0.1, 0.15).first, 0.339, 1e-12);
  EXPECT_NEAR(shown(10.0, 15.0).first, 0.339, 1e-12);
  EXPECT_NEAR(shown(0.1, 0.4).second, 0.791, 1e-12);  // the highlights are held
  EXPECT_NEAR(shown(0.1, 1.0).first, 0.141, 1e-12);   // but not at any price
  EXPECT_NEAR(shown(1e-6, 1.0).second, 4.0 * 0.791, 1e-9);
  EXPECT_NEAR(shown(1e-9, 1.5e-9).first, 0.339, 1e-12);  // a probe of the night
  EXPECT_NEAR(shown(1e9, 1.5e9).first, 0.339, 1e-12);    // of a lamp in candela per square metre
  EXPECT_EQ(exposureOf({0.0, 0.0}), 0.0);
  EXPECT_NEAR(shown(0.0, 1.0).second, 4.0 * 0.791, 1e-9);
}

}  // namespace
}  // namespace isolux::gi
