#include "scene/rules/ghosts.h"
#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

namespace isolux::scene {
namespace {

Scene withGhost() {
  Scene scene;
  scene.surfaces.front().value = 100.0;
  scene.surfaces.front().ghost = 2.0;
  scene.isosurface.ghostOpacity = 0.2;
  scene.derivatives.noise = 5.0;
  return scene;
}

TEST(Ghosts, LieOnBothSidesOfTheIsovalue) {
  Scene scene = withGhost();
  addGhosts(scene);
  EXPECT_TRUE(scene.surfaces.at(1).shown && scene.surfaces.at(2).shown);
  EXPECT_EQ(scene.surfaces.size(), 3U);
  EXPECT_EQ(scene.surfaces.at(1).value, 110.0);
  EXPECT_EQ(scene.surfaces.at(2).value, 90.0);
  EXPECT_EQ(scene.surfaces.at(2).opacity, 0.2);
}

TEST(Ghosts, FollowAllOtherSurfaces) {
  Scene scene = withGhost();
  test::surfaceAt(scene, 3).shown = true;
  test::surfaceAt(scene, 3).value = 7.0;
  addGhosts(scene);
  ASSERT_EQ(scene.surfaces.size(), 6U);
  EXPECT_EQ(scene.surfaces.at(3).value, 7.0);
  EXPECT_EQ(scene.surfaces.at(4).value, 110.0);
  EXPECT_EQ(scene.surfaces.at(5).value, 90.0);
}

TEST(Ghosts, ThereAreNoneWithoutNoise) {
  for (const std::optional<double> noise : {std::optional<double>(), std::optional(0.0)}) {
    Scene scene = withGhost();
    scene.derivatives.noise = noise;
    const Scene before = scene;
    addGhosts(scene);
    EXPECT_EQ(scene, before);
  }
}

}  // namespace
}  // namespace isolux::scene
