#include "scene/rules/ghosts.h"

#include <gtest/gtest.h>

namespace isolux::scene {
namespace {

Scene withGhost() {
  Scene scene;
  scene.isosurface.value = 100.0;
  scene.isosurface.ghost = 2.0;
  scene.isosurface.ghostOpacity = 0.2;
  scene.derivatives.noise = 5.0;
  return scene;
}

TEST(Ghosts, LieOnBothSidesOfTheIsovalue) {
  Scene scene = withGhost();
  EXPECT_EQ(ghostsWithoutRoom(scene), 0);
  addGhosts(scene);
  EXPECT_TRUE(scene.extraIsosurfaces[0].shown && scene.extraIsosurfaces[1].shown);
  EXPECT_FALSE(scene.extraIsosurfaces[2].shown);
  EXPECT_EQ(scene.extraIsosurfaces[0].value, 110.0);
  EXPECT_EQ(scene.extraIsosurfaces[1].value, 90.0);
  EXPECT_EQ(scene.extraIsosurfaces[1].opacity, 0.2);
}

TEST(Ghosts, LeaveIsosurfacesThatAreShown) {
  Scene scene = withGhost();
  scene.extraIsosurfaces[0].shown = scene.extraIsosurfaces[2].shown = true;
  scene.extraIsosurfaces[0].value = 7.0;
  EXPECT_EQ(ghostsWithoutRoom(scene), 1);
  addGhosts(scene);
  EXPECT_EQ(scene.extraIsosurfaces[0].value, 7.0);
  EXPECT_EQ(scene.extraIsosurfaces[1].value, 110.0);
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
