// Where marks lie in the picture, against rays, and what is behind the surface, by construction.
#include "app/view_math/mark_view.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "scene/rules/automatic.h"
#include "tests/support/volumes.h"

namespace isolux::test {
namespace {

TEST(MarkView, APointOfARayIsDrawnWhereTheRayCameFrom) {
  const auto volume = phantom("ball", 24);
  for (const auto projection : {scene::Projection::perspective, scene::Projection::orthographic}) {
    scene::Scene scene;
    scene.camera.projection = projection;
    scene = scene::resolve(scene, volume->facts);
    const scene::CameraFrame frame = scene::frameOf(scene.camera);
    const glm::dvec2 size(640, 400);
    for (const glm::dvec2& ndc : {glm::dvec2(0.0), glm::dvec2(0.7, -0.3), glm::dvec2(-0.2, 0.9)}) {
      const scene::Ray ray = scene::rayThrough(frame, ndc, size.x / size.y);
      const auto pixel = app::pixelOf(frame, ray.origin + 37.0 * ray.direction, size);
      ASSERT_TRUE(pixel);
      EXPECT_NEAR(pixel->x, 0.5 * (ndc.x + 1.0) * size.x, 1e-9);
      EXPECT_NEAR(pixel->y, 0.5 * (1.0 - ndc.y) * size.y, 1e-9);
    }
    const bool behind = projection == scene::Projection::perspective;  // the eye: nothing is drawn
    EXPECT_EQ(app::pixelOf(frame, frame.eye + frame.back, size).has_value(), !behind);
  }
}

TEST(MarkView, TheFarSideOfABallIsBehindIt) {
  const auto volume = phantom("ball", 48);
  const double r = 0.35 * 47.0;
  for (const auto projection : {scene::Projection::perspective, scene::Projection::orthographic}) {
    scene::Scene scene;
    scene.surfaces.front().value = 0.0;
    scene.camera.projection = projection;
    scene = scene::resolve(scene, volume->facts);
    const glm::dvec3 toEye = scene::frameOf(scene.camera).back;
    EXPECT_FALSE(app::isBehindSurface(*volume, scene, r * toEye, 1.3));
    EXPECT_FALSE(app::isBehindSurface(*volume, scene, (r + 3.0) * toEye, 1.3));
    EXPECT_TRUE(app::isBehindSurface(*volume, scene, glm::dvec3(0.0), 1.3));
    EXPECT_TRUE(app::isBehindSurface(*volume, scene, -r * toEye, 1.3));
    EXPECT_FALSE(app::isBehindSurface(*volume, scene, 3.0 * r * scene::frameOf(scene.camera).up, 1.3));
  }
}

TEST(MarkView, LongWaysAreThinnedAndKeepTheirEnds) {
  app::MarkReport report;
  for (int i = 0; i < 1000; ++i) report.line.emplace_back(i, 0, 0);
  const app::MarkShape shape =
      app::markShape({scene::MarkKind::path, "way", {{0, 0, 0}, {999, 0, 0}}}, report);
  ASSERT_EQ(shape.lines.size(), 1u);
  EXPECT_TRUE(shape.lines[0].onSurface);
  EXPECT_EQ(shape.lines[0].corners.size(), 128u);
  EXPECT_EQ(shape.lines[0].corners.front(), report.line.front());
  EXPECT_EQ(shape.lines[0].corners.back(), report.line.back());
}

TEST(MarkView, ACircleGoesThroughItsPoints) {
  app::MarkReport report;
  report.centre = glm::dvec3(1, 2, 3);
  report.normal = glm::dvec3(0, 0, 1);
  const app::MarkShape shape =
      app::markShape({scene::MarkKind::circle, "c", {{6, 2, 3}, {1, 7, 3}, {-4, 2, 3}}}, report);
  for (const glm::dvec3& corner : shape.lines.at(0).corners) {
    EXPECT_NEAR(glm::distance(corner, *report.centre), 5.0, 1e-9);
    EXPECT_NEAR(corner.z, 3.0, 1e-9);
  }
}

}  // namespace
}  // namespace isolux::test
