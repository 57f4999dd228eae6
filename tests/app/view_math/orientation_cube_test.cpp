// The orientation cube: each face gives the view from its side.
#include "app/view_math/orientation_cube.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "app/view_math/turning.h"

namespace isolux::test {
namespace {

scene::Camera cameraFrom(glm::dvec3 eye, glm::dvec3 up = {0.0, 0.0, 1.0}) {
  scene::Camera camera;
  camera.eye = eye;
  camera.target = glm::dvec3(0.0);
  camera.up = up;
  return camera;
}

TEST(OrientationCube, AFaceGivesTheViewInWhichItIsSeenAlone) {
  for (const auto axes : {scene::WorldAxes::anatomical, scene::WorldAxes::zUp, scene::WorldAxes::yUp})
    for (const glm::dvec3& eye : {glm::dvec3(300.0, -200.0, 150.0), glm::dvec3(-100.0, 250.0, -220.0)}) {
      const scene::Camera camera = cameraFrom(eye, upOf(axes));
      const auto faces = app::cubeFaces(frameOf(camera), axes, 17.0);
      ASSERT_EQ(faces.size(), 3u);
      for (const app::CubeFace& face : faces) {
        EXPECT_EQ(app::faceAt(faces, face.middle), face.view);
        const scene::Camera turned =
            standardView(camera, face.view, axes, glm::dvec3(-10.0), glm::dvec3(10.0));
        const auto alone = app::cubeFaces(frameOf(turned), axes, 17.0);
        ASSERT_EQ(alone.size(), 1u) << face.letter;
        EXPECT_EQ(alone[0].letter, face.letter);
        EXPECT_EQ(alone[0].view, face.view);
        EXPECT_NEAR(alone[0].facing, 1.0, 1e-12);
      }
      EXPECT_FALSE(app::faceAt(faces, {40.0, 0.0}));
    }
}

TEST(CameraTurn, BeginsAndEndsThereAndTurnsEvenly) {
  const scene::Camera from = cameraFrom({0.0, -400.0, 0.0}), to = cameraFrom({100.0, 0.0, 0.0});
  EXPECT_EQ(app::cameraBetween(from, to, 1.0), to);
  const auto begin = frameOf(app::cameraBetween(from, to, 0.0));
  EXPECT_LT(glm::distance(begin.eye, *from.eye), 1e-9);
  // A quarter turn about z: at a third of the way 30 degrees, and the distance 400 (1/4)^(1/3).
  const auto third = frameOf(app::cameraBetween(from, to, 1.0 / 3.0));
  EXPECT_NEAR(third.distance, 400.0 * std::cbrt(0.25), 1e-9);
  EXPECT_LT(glm::distance(third.back, {0.5, -std::sqrt(0.75), 0.0}), 1e-12);
  EXPECT_LT(glm::distance(third.up, {0.0, 0.0, 1.0}), 1e-12);
}

TEST(CameraTurn, IsSlowAtBothEnds) {
  EXPECT_EQ(app::easedPart(0.0), 0.0);
  EXPECT_EQ(app::easedPart(0.5), 0.5);
  EXPECT_EQ(app::easedPart(2.0), 1.0);
  EXPECT_LT(app::easedPart(0.1), 0.1);
}

}  // namespace
}  // namespace isolux::test
