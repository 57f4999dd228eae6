// The point under the pointer against closed forms.
#include "app/view_math/surface_pick.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/progress.h"
#include "scene/rules/automatic.h"
#include "tests/support/surfaces.h"
#include "tests/support/volumes.h"

namespace isolux::test {
namespace {

scene::Scene resolved(const volume::PreparedVolume& volume, scene::Scene scene = {}) {
  return scene::resolve(scene, volume.facts);
}

}  // namespace

TEST(SurfacePick, IsOnTheRayAndOnTheSurface) {
  const auto volume = phantom("ball", 48);
  const scene::Scene scene = resolved(*volume);
  const scene::CameraFrame frame = scene::frameOf(scene.camera);
  constexpr double aspect = 1.5;
  for (const glm::dvec2& ndc : {glm::dvec2(0.0), glm::dvec2(0.11, -0.2), glm::dvec2(-0.25, 0.3)}) {
    const auto pick = app::pickSurface(*volume, scene, ndc, aspect);
    ASSERT_TRUE(pick);
    const scene::Ray ray = scene::rayThrough(frame, ndc, aspect);
    EXPECT_LT(glm::length(glm::cross(pick->worldMm - ray.origin, glm::normalize(ray.direction))), 1e-9);
    EXPECT_NEAR(pick->value, *scene.surfaces.front().value,
                1e-9 * std::abs(*scene.surfaces.front().value) + 1e-9);
    const glm::dvec3 back(volume->grid().geometry().worldFromVoxel * glm::dvec4(pick->voxel, 1.0));
    EXPECT_LT(glm::distance(back, pick->worldMm), 1e-9);
  }
  EXPECT_FALSE(app::pickSurface(*volume, scene, {0.99, 0.99}, aspect));
}

TEST(SurfacePick, OfABallIsItsRadiusAway) {
  const auto volume = phantom("ball", 65);
  scene::Scene scene;
  scene.surfaces.front().value = 0.0;
  scene = resolved(*volume, scene);
  for (const glm::dvec2& ndc : {glm::dvec2(0.0), glm::dvec2(0.2, 0.1), glm::dvec2(-0.1, 0.25)}) {
    const auto pick = app::pickSurface(*volume, scene, ndc, 1.2);
    ASSERT_TRUE(pick);
    EXPECT_NEAR(glm::length(pick->worldMm), 0.35 * 64.0, 0.05);
  }
}

// Of several isosurfaces the nearest that is shown and not fully transparent.
TEST(SurfacePick, TakesTheNearestThatIsShown) {
  const auto volume = phantom("ball", 48);
  scene::Scene scene;
  scene = resolved(*volume, scene);
  const double first = *scene.surfaces.front().value;
  const auto alone = app::pickSurface(*volume, scene, {0.0, 0.0}, 1.0);
  test::surfaceAt(scene, 1).value = 0.9 * first + 0.1 * volume->grid().minimum();
  test::surfaceAt(scene, 1).opacity = 0.5;
  const auto hidden = app::pickSurface(*volume, scene, {0.0, 0.0}, 1.0);
  ASSERT_TRUE(alone && hidden);
  EXPECT_EQ(hidden->worldMm, alone->worldMm);
  test::surfaceAt(scene, 1).shown = true;
  const auto shown = app::pickSurface(*volume, scene, {0.0, 0.0}, 1.0);
  scene.surfaces.front().opacity = 0.0;
  const auto other = app::pickSurface(*volume, scene, {0.0, 0.0}, 1.0);
  ASSERT_TRUE(shown && other);
  const glm::dvec3 eye = scene::frameOf(scene.camera).eye;
  EXPECT_DOUBLE_EQ(glm::distance(shown->worldMm, eye),
                   std::min(glm::distance(alone->worldMm, eye), glm::distance(other->worldMm, eye)));
  EXPECT_GT(glm::distance(other->worldMm, alone->worldMm), 0.1);
}

// A field that is not made yet is that of the cells, as in the picture.
TEST(SurfacePick, FollowsTheFieldOnceItIsThere) {
  const auto volume = phantom("gyroid", 32);
  scene::Scene scene = resolved(*volume);
  const auto trilinear = app::pickSurface(*volume, scene, {0.1, 0.1}, 1.0);
  scene.hit.field = scene::Field::cubic;
  const auto before = app::pickSurface(*volume, scene, {0.1, 0.1}, 1.0);
  base::Progress progress;
  volume->cubicFields->makeFor(scene, progress);
  const auto after = app::pickSurface(*volume, scene, {0.1, 0.1}, 1.0);
  ASSERT_TRUE(trilinear && before && after);
  EXPECT_EQ(before->worldMm, trilinear->worldMm);
  EXPECT_NE(after->worldMm, trilinear->worldMm);
}

}  // namespace isolux::test
