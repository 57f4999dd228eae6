#include "gi/trace/exposure_meter.h"

#include <cmath>

#include <gtest/gtest.h>

#include "scene/rules/automatic.h"
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
    return measureBrightness(resolved(), volume_, tracer, loadEnvironment(scene_.light.environment),
                             progress);
  }
  static double brightnessOf(double luminance, double stops) { return luminance * std::exp2(stops); }

  std::shared_ptr<const volume::PreparedVolume> volume_ = test::phantom("ball", 24);
  scene::Scene scene_;
};

TEST_F(ExposureMeter, AConvexSurfaceUnderAnEvenSkyIsAsBrightAsItsAlbedo) {
  scene_.light.environment.constant = glm::dvec3(2.0, 2.0, 2.0);
  scene_.light.environment.exposure = 1.0;
  scene_.isosurface.albedo = glm::dvec3(0.25);
  const auto seen = measured();
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->median, 0.25 * 2.0 * 2.0, 2e-3);
  EXPECT_NEAR(seen->highlight, 0.25 * 2.0 * 2.0, 2e-2);
}

TEST_F(ExposureMeter, ALampCountsAsItLights) {
  scene_.light.environment.constant = glm::dvec3(0.0);
  scene_.isosurface.albedo = glm::dvec3(0.5);
  scene_.gi.bounces = 0;
  scene_.lamps[0].shown = true;
  scene_.lamps[0].kind = scene::LampKind::directional;
  scene_.lamps[0].direction = glm::dvec3(0.0, -1.0, 0.0);  // from the front
  const auto seen = measured();
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->highlight, 0.5, 0.02);  // faces the lamp: 1, times the albedo
  EXPECT_LT(seen->median, seen->highlight);
}

TEST_F(ExposureMeter, ViewAndPictureDoNotEnter) {
  scene::Scene other = resolved();
  other.camera.eye = glm::dvec3(500.0, 20.0, 3.0);
  other.camera.fov = 11.0;
  other.picture.supersampling = 1;
  other.gi.samples = 7;
  other.gi.interpolation = scene::GiInterpolation::nearest;
  other.light.environment.moves = true;
  EXPECT_EQ(meteredScene(other), meteredScene(resolved()));
  other.isosurface.albedo.x *= 0.5;
  EXPECT_NE(meteredScene(other), meteredScene(resolved()));
}

TEST_F(ExposureMeter, IsTheSameEveryTime) {
  const auto a = measured(), b = measured();
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->median, b->median);
  EXPECT_EQ(a->highlight, b->highlight);
}

TEST_F(ExposureMeter, NothingIsSeenWhereThereIsNoSurface) {
  scene_.isosurface.value = 1e6;
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
