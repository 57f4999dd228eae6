#include "scene/opacity.h"

#include <gtest/gtest.h>

#include "scene/rules/needs.h"

namespace isolux::scene {
namespace {

TEST(Opacity, KeepsTheEdgeAndLessensWhatFacesTheViewer) {
  EXPECT_DOUBLE_EQ(opacityAt(0.8, 0.25, 0.0), 0.8);
  EXPECT_DOUBLE_EQ(opacityAt(0.8, 0.25, 1.0), 0.2);
  EXPECT_DOUBLE_EQ(opacityAt(0.8, 1.0, 0.3), 0.8);
  // The mean over a hemisphere, weighted with the cosine, by sums.
  double sum = 0.0;
  constexpr int steps = 10000;
  for (int i = 0; i < steps; ++i) {
    const double c = (i + 0.5) / steps;
    sum += 2.0 * c * opacityAt(0.8, 0.25, c) / steps;
  }
  EXPECT_NEAR(meanOpacity(0.8, 0.25), sum, 1e-6);
}

TEST(Opacity, ASurfaceThatIsSeenThroughFromTheFrontIsTransparent) {
  Scene scene;
  EXPECT_FALSE(isTransparent(scene));
  EXPECT_FALSE(variesByAngle(scene));
  scene.isosurface.facingOpacity = 0.5;
  EXPECT_TRUE(isTransparent(scene) && variesByAngle(scene));
  scene.isosurface.opacity = 0.0;
  EXPECT_FALSE(isTransparent(scene) || variesByAngle(scene));
  scene.extraIsosurfaces[1].opacity = 1.0;
  scene.extraIsosurfaces[1].facingOpacity = 0.0;
  EXPECT_FALSE(isTransparent(scene));
  scene.extraIsosurfaces[1].shown = true;
  EXPECT_TRUE(isTransparent(scene) && variesByAngle(scene));
}

}  // namespace
}  // namespace isolux::scene
