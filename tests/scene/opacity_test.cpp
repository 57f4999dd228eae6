#include "scene/opacity.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "scene/rules/needs.h"
#include "tests/support/surfaces.h"

namespace isolux::scene {
namespace {

TEST(Opacity, KeepsTheEdgeAndLessensWhatFacesTheViewer) {
  EXPECT_DOUBLE_EQ(opacityAt(0.8, 0.25, 0.0), 0.8);
  EXPECT_DOUBLE_EQ(opacityAt(0.8, 0.25, 1.0), 0.2);
  EXPECT_DOUBLE_EQ(opacityAt(0.8, 1.0, 0.3), 0.8);
}

// A layer lets 2 E3 of its optical depth through, by the exponential integral.
TEST(Opacity, TheMeanIsThatOfALayerUnderUniformLight) {
  for (const double opacity : {0.05, 0.3, 0.9}) {
    const double depth = -std::log(1.0 - opacity);
    const double through = std::exp(-depth) * (1.0 - depth) - depth * depth * std::expint(-depth);
    EXPECT_NEAR(meanOpacity(opacity, 1.0), 1.0 - through, 2e-4);
  }
  EXPECT_EQ(meanOpacity(1.0, 1.0), 1.0);
  EXPECT_EQ(meanOpacity(0.0, 0.5), 0.0);
  EXPECT_LT(meanOpacity(0.3, 0.25), 0.5 * meanOpacity(0.3, 1.0));
}

// Paths within a hollow sphere, from its wall: they meet the wall at the angle at which they leave it.
TEST(Opacity, LightBehindALayerIsThatOfTracedPaths) {
  constexpr double opacity = 0.3, facing = 0.6, albedo = 0.7;
  constexpr int paths = 200000;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  double light = 0.0;
  for (int path = 0; path < paths; ++path)
    for (double weight = 1.0;; weight *= albedo) {
      const double cosine = std::sqrt(1.0 - uniform(random));
      if (uniform(random) < std::pow(1.0 - opacityAt(opacity, facing, cosine), 1.0 / cosine)) {
        light += weight / paths;
        break;
      }
    }
  EXPECT_NEAR(lightThrough(meanOpacity(opacity, facing), albedo), light, 2e-3);
  EXPECT_DOUBLE_EQ(lightThrough(0.4, 1.0), 1.0) << "a white shell loses no light";
}

// No step where an opacity is dragged.
TEST(Opacity, TheShadowOfALayerFadesIn) {
  EXPECT_EQ(shadowShown(0.5), 0.0);
  EXPECT_NEAR(shadowShown(0.51), 0.0, 0.03);
  EXPECT_EQ(shadowShown(1.0), 1.0);
}

TEST(Opacity, ASurfaceThatIsSeenThroughFromTheFrontIsTransparent) {
  Scene scene;
  EXPECT_FALSE(isTransparent(scene));
  EXPECT_FALSE(variesByAngle(scene));
  scene.surfaces.front().facingOpacity = 0.5;
  EXPECT_TRUE(isTransparent(scene) && variesByAngle(scene));
  scene.surfaces.front().opacity = 0.0;
  EXPECT_FALSE(isTransparent(scene) || variesByAngle(scene));
  test::surfaceAt(scene, 2).opacity = 1.0;
  test::surfaceAt(scene, 2).facingOpacity = 0.0;
  EXPECT_FALSE(isTransparent(scene));
  test::surfaceAt(scene, 2).shown = true;
  EXPECT_TRUE(isTransparent(scene) && variesByAngle(scene));
}

}  // namespace
}  // namespace isolux::scene
