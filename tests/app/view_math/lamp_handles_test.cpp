// Lamp handles as arithmetic, against the camera's rays.
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "app/view_math/lamp_handles.h"
#include "tests/support/lamps.h"

namespace isolux::app {

namespace {

scene::Scene sceneWithLamp(scene::LampKind kind, scene::Projection projection) {
  scene::Scene scene;
  scene.look.mode = scene::LookMode::gi;
  scene.camera.eye = glm::dvec3(60.0, -280.0, 90.0);
  scene.camera.target = glm::dvec3(4.0, 2.0, -3.0);
  scene.camera.up = glm::dvec3(0.1, 0.2, 1.0);
  scene.camera.projection = projection;
  test::lampAt(scene, 1).shown = true;
  test::lampAt(scene, 1).kind = kind;
  test::lampAt(scene, 1).position = glm::dvec3(20.0, -30.0, 25.0);
  test::lampAt(scene, 1).direction = glm::dvec3(0.4, -2.0, 0.9);
  test::lampAt(scene, 1).radius = 12.0;
  return scene;
}

scene::VolumeFacts box() {
  scene::VolumeFacts facts;
  facts.boundsMinMm = glm::dvec3(-50.0, -40.0, -45.0);
  facts.boundsMaxMm = glm::dvec3(50.0, 40.0, 45.0);
  return facts;
}

constexpr scene::Projection projections[] = {scene::Projection::perspective, scene::Projection::orthographic};
const glm::dvec2 pixels(800.0, 600.0);

scene::Ray rayAt(const scene::Scene& scene, glm::dvec2 pixel) {
  return scene::rayThrough(scene::frameOf(scene.camera),
                           {2.0 * pixel.x / pixels.x - 1.0, 1.0 - 2.0 * pixel.y / pixels.y},
                           pixels.x / pixels.y);
}

double distanceToRay(const scene::Ray& ray, glm::dvec3 point) {
  return glm::length(glm::cross(point - ray.origin, ray.direction));
}

LampStage stageOf(const scene::Scene& scene) {
  return lampStageOf(scene, box(), pixels);
}

}  // namespace

TEST(LampHandles, LieUnderTheLampAndOnlyUnderGlobalIllumination) {
  for (const scene::Projection projection : projections) {
    scene::Scene scene = sceneWithLamp(scene::LampKind::point, projection);
    const auto handles = lampHandles(scene, stageOf(scene));
    ASSERT_EQ(handles.size(), 1U);
    EXPECT_EQ(handles[0].number, 2);
    EXPECT_FALSE(handles[0].outside);
    EXPECT_LT(distanceToRay(rayAt(scene, handles[0].pixel), test::lampAt(scene, 1).position.value()), 1e-9);
    scene.look.mode = scene::LookMode::lambert;
    EXPECT_TRUE(lampHandles(scene, stageOf(scene)).empty());
  }
}

TEST(LampHandles, DraggingBringsTheLampUnderThePointerInItsPlane) {
  for (const scene::Projection projection : projections) {
    scene::Scene scene = sceneWithLamp(scene::LampKind::point, projection);
    const glm::dvec3 before = test::lampAt(scene, 1).position.value(),
                     back = scene::frameOf(scene.camera).back;
    const glm::dvec2 pixel(123.0, 456.0);
    test::lampAt(scene, 1) = lampMovedTo(test::lampAt(scene, 1), stageOf(scene), pixel);
    EXPECT_LT(distanceToRay(rayAt(scene, pixel), test::lampAt(scene, 1).position.value()), 1e-9);
    EXPECT_NEAR(glm::dot(test::lampAt(scene, 1).position.value() - before, back), 0.0, 1e-9);
  }
}

TEST(LampHandles, MovingInDepthKeepsTheHandle) {
  for (const scene::Projection projection : projections) {
    scene::Scene scene = sceneWithLamp(scene::LampKind::sphere, projection);
    const glm::dvec3 before = test::lampAt(scene, 1).position.value(),
                     back = scene::frameOf(scene.camera).back;
    const glm::dvec2 handle = lampHandles(scene, stageOf(scene))[0].pixel;
    test::lampAt(scene, 1) = lampMovedAway(test::lampAt(scene, 1), stageOf(scene), 0.2);
    EXPECT_LT(glm::distance(lampHandles(scene, stageOf(scene))[0].pixel, handle), 1e-9);
    EXPECT_LT(glm::dot(test::lampAt(scene, 1).position.value() - before, back), -1.0);  // away
  }
}

TEST(LampHandles, ADistantLampsHandleFollowsThePointerOverTheBall) {
  for (const scene::Projection projection : projections) {
    for (const glm::dvec2& pixel : {glm::dvec2(430.0, 280.0), glm::dvec2(300.0, 400.0)}) {
      for (const double side : {1.0, -1.0}) {
        scene::Scene scene = sceneWithLamp(scene::LampKind::directional, projection);
        test::lampAt(scene, 1).direction = side * scene::frameOf(scene.camera).back;
        const LampStage stage = stageOf(scene);
        test::lampAt(scene, 1) = lampMovedTo(test::lampAt(scene, 1), stage, pixel);
        const auto handle = lampHandles(scene, stage).at(0);
        EXPECT_LT(glm::distance(handle.pixel, pixel), 1e-6);
        EXPECT_EQ(handle.far, side < 0.0);
        EXPECT_NEAR(glm::length(test::lampAt(scene, 1).direction), stage.reachMm, 1e-9 * stage.reachMm);
      }
    }
  }
}

TEST(LampHandles, BeyondTheRimADistantLampStaysOnIt) {
  scene::Scene scene = sceneWithLamp(scene::LampKind::directional, scene::Projection::orthographic);
  const LampStage stage = stageOf(scene);
  test::lampAt(scene, 1) = lampMovedTo(test::lampAt(scene, 1), stage, {790.0, 300.0});
  EXPECT_NEAR(glm::dot(test::lampAt(scene, 1).direction, stage.frame.back), 0.0, 1e-9);
  EXPECT_GT(glm::dot(test::lampAt(scene, 1).direction, stage.frame.right), 0.9 * stage.reachMm);
}

TEST(LampHandles, TheOutlineIsThatOfTheSphereAndSetsItsRadius) {
  for (const scene::Projection projection : projections) {
    scene::Scene scene = sceneWithLamp(scene::LampKind::sphere, projection);
    const glm::dvec3 place(4.0, 2.0, -3.0);  // on the axis the outline is a circle
    test::lampAt(scene, 1).position = place;
    const LampHandle handle = lampHandles(scene, stageOf(scene)).at(0);
    const scene::Ray tangent = rayAt(scene, handle.pixel + glm::dvec2(handle.ringPixels, 0.0));
    EXPECT_NEAR(distanceToRay(tangent, place), 12.0, 1e-9);
    const glm::dvec2 edge = handle.pixel + glm::dvec2(0.0, 90.0);
    EXPECT_EQ(lampAt({handle}, handle.pixel + glm::dvec2(handle.ringPixels, 0.0)),
              (LampGrip{"light2", 2, LampPart::ring}));
    test::lampAt(scene, 1) = lampResizedTo(test::lampAt(scene, 1), stageOf(scene), edge);
    EXPECT_NEAR(lampHandles(scene, stageOf(scene)).at(0).ringPixels, 90.0, 1e-9);
  }
}

TEST(LampHandles, OneThatIsNotOnThePictureStandsAtItsEdgeAndSaysWhere) {
  scene::Scene scene = sceneWithLamp(scene::LampKind::point, scene::Projection::perspective);
  const LampStage stage = stageOf(scene);
  const scene::CameraFrame& frame = stage.frame;
  for (const glm::dvec3& place : {stage.centreMm + 900.0 * frame.right, frame.eye + 50.0 * frame.back,
                                  frame.eye + 200.0 * frame.back - 90.0 * frame.up, frame.eye}) {
    test::lampAt(scene, 1).position = place;
    const LampHandle handle = lampHandles(scene, stage).at(0);
    EXPECT_TRUE(handle.outside);
    EXPECT_TRUE(handle.pixel.x >= 0 && handle.pixel.y >= 0 && handle.pixel.x <= 800 && handle.pixel.y <= 600)
        << handle.pixel.x << ' ' << handle.pixel.y;
    EXPECT_NEAR(glm::length(handle.toward), 1.0, 1e-12);
    EXPECT_EQ(lampAt({handle}, handle.pixel), (LampGrip{"light2", 2, LampPart::handle}));
    // A drag brings it before the eye, under the pointer.
    test::lampAt(scene, 1) = lampMovedTo(test::lampAt(scene, 1), stage, {200.0, 200.0});
    EXPECT_LT(glm::distance(lampHandles(scene, stage).at(0).pixel, glm::dvec2(200.0)), 1e-6);
  }
}

}  // namespace isolux::app
