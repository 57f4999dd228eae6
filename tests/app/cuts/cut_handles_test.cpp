// Handles of cuts as arithmetic: against the camera's rays, and what is left of the volume
// (volume/clip/clip_region.h).
#include <cmath>
#include <functional>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "app/cuts/cut_drag.h"
#include "volume/clip/clip_region.h"

namespace isolux::app {
namespace {

const glm::dvec2 kPixels(800.0, 600.0);

volume::GridGeometry cutGrid() {
  return volume::GridGeometry::make({81, 61, 51}, {1.0, 1.0, 1.0}, {-40.0, -30.0, -25.0});
}

scene::Scene viewOf(scene::Projection projection) {
  scene::Scene scene;
  scene.camera.eye = glm::dvec3(120.0, -210.0, 90.0);
  scene.camera.target = glm::dvec3(2.0, 1.0, -3.0);
  scene.camera.up = glm::dvec3(0.1, 0.2, 1.0);
  scene.camera.projection = projection;
  return scene;
}
constexpr scene::Projection kProjections[] = {scene::Projection::perspective,
                                              scene::Projection::orthographic};

CutStage stageOf(const scene::Scene& scene) {
  return cutStageOf(scene, cutGrid(), kPixels);
}

scene::Ray rayOf(const scene::Scene& scene, glm::dvec2 pixel) {
  return scene::rayThrough(scene::frameOf(scene.camera),
                           {2.0 * pixel.x / kPixels.x - 1.0, 1.0 - 2.0 * pixel.y / kPixels.y},
                           kPixels.x / kPixels.y);
}
double distanceToRay(const scene::Ray& ray, glm::dvec3 point) {
  return glm::length(glm::cross(point - ray.origin, ray.direction));
}
const CutKnob& knob(const std::vector<CutShape>& shapes, const CutGrip& grip) {
  for (const CutShape& shape : shapes)
    for (const CutKnob& one : shape.knobs)
      if (one.grip == grip) return one;
  throw std::logic_error("no such knob");
}
scene::Clip onePlane() {
  scene::Clip clip;
  clip.planes = {{{3.0, -2.0, 5.0}, {0.6, 0.5, 2.0}}};
  return clip;
}
scene::Clip turnedBoxCut() {
  scene::Clip clip;
  clip.box = {{-20, -10, -12}, {25, 14, 9}};
  clip.boxRotation = {0.9, 0.2, -0.3, 0.1};
  return clip;
}
const CutGrip kMovePlane{1, CutPart::move, 0}, kTurnPlane{1, CutPart::turn, 0};

TEST(CutHandles, LieOnThePlaneAndUnderThePointer) {
  for (const scene::Projection projection : kProjections) {
    const scene::Scene scene = viewOf(projection);
    const CutStage stage = stageOf(scene);
    const scene::Clip clip = onePlane();
    const auto shapes = cutShapes(clip, stage);
    ASSERT_EQ(shapes.size(), 1u);
    const glm::dvec3 middle = middleOf(clip.planes[0], stage.volumeMm);
    const glm::dvec2 at = knob(shapes, kMovePlane).pixel;
    EXPECT_LT(distanceToRay(rayOf(scene, at), middle), 1e-9);
    EXPECT_EQ(cutAt(shapes, at + glm::dvec2(5.0, -6.0)), kMovePlane);
    EXPECT_EQ(cutAt(shapes, knob(shapes, kTurnPlane).pixel), kTurnPlane);
    const CutLine& line = shapes[0].outline[0];
    EXPECT_EQ(cutAt(shapes, 0.7 * line.from + 0.3 * line.to), kMovePlane);  // the outline moves, too
    EXPECT_FALSE(cutAt(shapes, {3.0, 3.0}));
    EXPECT_TRUE(cutShapes({}, stage).empty());
  }
}

// Whatever the plane's side, what was under the pointer stays under it: the plane moves along its normal by
// what the pointer's ray says.
TEST(CutHandles, DraggingAPlaneFollowsThePointerAlongItsNormal) {
  for (const scene::Projection projection : kProjections)
    for (const double side : {1.0, -1.0}) {
      const scene::Scene scene = viewOf(projection);
      const CutStage stage = stageOf(scene);
      scene::Clip clip = onePlane();
      clip.planes[0].normal *= side;
      const glm::dvec3 normal = glm::normalize(clip.planes[0].normal), start = knobOf(clip, 0, stage);
      for (const double mm : {-9.0, 4.0, 13.0}) {
        const glm::dvec2 from = projectedOn(stage, start).pixel,
                         to = projectedOn(stage, start + mm * normal).pixel;
        const scene::Clip dragged = draggedCut(clip, kMovePlane, stage, from, to, false);
        EXPECT_EQ(dragged.planes[0].normal, clip.planes[0].normal);
        EXPECT_NEAR(glm::dot(normal, dragged.planes[0].point - clip.planes[0].point), mm, 1e-6);
        // Of the way across the axis nothing counts in an orthographic picture.
        EXPECT_EQ(draggedCut(clip, kMovePlane, stage, from, from, false), clip);
      }
    }
}

TEST(CutHandles, APlaneStaysWithinTheVolume) {
  const scene::Scene scene = viewOf(scene::Projection::perspective);
  const CutStage stage = stageOf(scene);
  const scene::Clip clip = onePlane();
  for (const glm::dvec2& to :
       {glm::dvec2(400.0, -5000.0), glm::dvec2(400.0, 9000.0), glm::dvec2(-8000.0, 0.0)}) {
    const scene::Clip dragged = draggedCut(clip, kMovePlane, stage, {400.0, 300.0}, to, false);
    bool before = false, behind = false;
    for (const glm::dvec3& corner : stage.volumeMm) {
      const double above = glm::dot(dragged.planes[0].normal, corner - dragged.planes[0].point);
      before = before || above >= -1e-9;
      behind = behind || above <= 1e-9;
    }
    EXPECT_TRUE(before && behind);
  }
}

// Seen along its normal a plane moves by the pointer's height: up is away.
TEST(CutHandles, APlaneThatFacesTheViewerMovesByHeight) {
  for (const scene::Projection projection : kProjections)
    for (const double side : {1.0, -1.0}) {
      const scene::Scene scene = viewOf(projection);
      const CutStage stage = stageOf(scene);
      scene::Clip clip;
      clip.planes = {{{0, 0, 0}, side * stage.frame.back}};
      const glm::dvec2 from = projectedOn(stage, knobOf(clip, 0, stage)).pixel;
      const double mmPerPixel = projectedOn(stage, knobOf(clip, 0, stage)).mmPerPixel;
      const scene::Clip dragged =
          draggedCut(clip, kMovePlane, stage, from, from - glm::dvec2(0.0, 40.0), false);
      EXPECT_NEAR(glm::dot(stage.frame.back, dragged.planes[0].point), -40.0 * mmPerPixel, 1e-6);
      const auto shapes = cutShapes(clip, stage);  // and the arrow is not under the knob
      EXPECT_GE(glm::distance(knob(shapes, kTurnPlane).pixel, knob(shapes, kMovePlane).pixel),
                kCutArrowLeast - 1e-9);
    }
}

TEST(CutHandles, TheArrowsTipComesUnderThePointerAndThePlaneTurnsAboutItsKnob) {
  for (const scene::Projection projection : kProjections) {
    const scene::Scene scene = viewOf(projection);
    const CutStage stage = stageOf(scene);
    const scene::Clip clip = onePlane();
    const glm::dvec3 middle = knobOf(clip, 0, stage);
    const ProjectedPoint place = projectedOn(stage, middle);
    const glm::dvec2 from = knob(cutShapes(clip, stage), kTurnPlane).pixel;
    const glm::dvec2 to = place.pixel + glm::dvec2(-30.0, 12.0);
    const scene::Clip turned = draggedCut(clip, kTurnPlane, stage, from, to, false);
    const glm::dvec3 normal = glm::normalize(turned.planes[0].normal);
    EXPECT_LT(glm::distance(turned.planes[0].point, middle), 1e-9);
    const glm::dvec3 tip = middle + kCutArrow * place.mmPerPixel * normal;
    EXPECT_LT(distanceToRay(rayOf(scene, to), tip), 1e-6);
    EXPECT_GT(glm::dot(normal, stage.frame.back), 0.0);  // the side that it was on
    // Far beyond the ball it lies in the picture's plane, toward the pointer.
    const glm::dvec3 flat =
        draggedCut(clip, kTurnPlane, stage, from, {790.0, place.pixel.y}, false).planes[0].normal;
    EXPECT_GT(glm::dot(glm::normalize(flat), stage.frame.right), 0.9);
  }
}

TEST(CutHandles, ConstrainedNormalsGoToAxesAndBetweenTwo) {
  const CutStage stage = stageOf(viewOf(scene::Projection::orthographic));
  const scene::Clip clip = onePlane();
  const glm::dvec2 from = knob(cutShapes(clip, stage), kTurnPlane).pixel;
  for (int i = 0; i < 40; ++i) {
    const glm::dvec2 to = from + 60.0 * glm::dvec2(std::sin(0.7 * i), std::cos(1.1 * i));
    const glm::dvec3 n = draggedCut(clip, kTurnPlane, stage, from, to, true).planes[0].normal;
    int parts = 0;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(n[axis], std::round(n[axis]));
      parts += n[axis] != 0.0;
    }
    EXPECT_TRUE(parts == 1 || parts == 2);
  }
}

// Each face follows the pointer along its own axis and the opposite one stays: what is kept tells.
TEST(CutHandles, AFaceOfTheBoxMovesAloneWhereverTheBoxIsTurned) {
  for (const scene::Projection projection : kProjections) {
    const CutStage stage = stageOf(viewOf(projection));
    const scene::Clip clip = turnedBoxCut();
    const TurnedBox before = turnedBox(clip);
    for (int face = 0; face < 6; ++face) {
      const int axis = face / 2;
      const double side = face % 2 ? 1.0 : -1.0;
      const CutGrip grip{0, CutPart::face, face};
      const glm::dvec3 outward = side * before.axes[axis], at = before.middle + before.half[axis] * outward;
      const glm::dvec2 from = projectedOn(stage, at).pixel, to = projectedOn(stage, at + 3.0 * outward).pixel;
      const scene::Clip dragged = draggedCut(clip, grip, stage, from, to, false);
      EXPECT_EQ(dragged.boxRotation, clip.boxRotation);
      const volume::ClipRegion region(dragged);
      const glm::dvec3 opposite = before.middle - before.half[axis] * outward;
      if (glm::length(glm::cross(stage.frame.back, outward)) > 0.3) {
        EXPECT_TRUE(region.contains(at + 2.999 * outward)) << face;
        EXPECT_FALSE(region.contains(at + 3.001 * outward)) << face;
      }
      EXPECT_TRUE(region.contains(opposite + 1e-6 * outward)) << face;
      EXPECT_FALSE(region.contains(opposite - 1e-6 * outward)) << face;
      // Pushed through the opposite one it stops before it.
      const scene::Clip flat = draggedCut(clip, grip, stage, from, 50.0 * (from - to) + from, false);
      EXPECT_GT(turnedBox(flat).half[axis], 0.0);
    }
  }
}

// A removed box has the same handles, but for those that turn it; a drag moves it alone.
TEST(CutHandles, RemovedBoxesHaveFacesAndAMiddleToDrag) {
  const scene::Scene scene = viewOf(scene::Projection::perspective);
  const CutStage stage = stageOf(scene);
  scene::Clip clip = turnedBoxCut();
  clip.removed = {{-5, -4, -3}, {6, 5, 4}, {0, 1, 2}, {9, 8, 7}};
  const auto shapes = cutShapes(clip, stage);
  ASSERT_EQ(shapes.size(), 3u);
  EXPECT_EQ(shapes[2].plane, -2);
  EXPECT_EQ(shapes[2].outline.size(), 12u);
  EXPECT_EQ(shapes[2].knobs.size(), 7u);
  const CutGrip face{-2, CutPart::face, 1};
  ASSERT_TRUE(hasGrip(clip, face));
  EXPECT_FALSE(hasGrip(clip, {-3, CutPart::face, 1}));
  const TurnedBox box = turnedBox(clip, -2);
  const glm::dvec3 from = box.middle + glm::dvec3(box.half.x, 0, 0), to = from + glm::dvec3(3, 0, 0);
  const scene::Clip dragged =
      draggedCut(clip, face, stage, projectedOn(stage, from).pixel, projectedOn(stage, to).pixel, false);
  EXPECT_EQ(dragged.box, clip.box);
  EXPECT_LT(glm::distance(dragged.removed[0], clip.removed[0]), 1e-12);
  EXPECT_LT(glm::distance(dragged.removed[2], clip.removed[2]), 1e-9);
  EXPECT_LT(glm::distance(dragged.removed[3], clip.removed[3] + glm::dvec3(3, 0, 0)), 1e-6);
}

TEST(CutHandles, TheBoxMovesParallelToTheScreen) {
  for (const scene::Projection projection : kProjections) {
    const scene::Scene scene = viewOf(projection);
    const CutStage stage = stageOf(scene);
    const scene::Clip clip = turnedBoxCut();
    const glm::dvec2 from = projectedOn(stage, turnedBox(clip).middle).pixel,
                     to = from + glm::dvec2(40.0, -25.0);
    const scene::Clip moved = draggedCut(clip, {0, CutPart::move, 0}, stage, from, to, false);
    const TurnedBox box = turnedBox(moved), before = turnedBox(clip);
    EXPECT_LT(distanceToRay(rayOf(scene, to), box.middle), 1e-9);
    EXPECT_NEAR(glm::dot(box.middle - before.middle, stage.frame.back), 0.0, 1e-9);
    EXPECT_LT(glm::distance(box.half, before.half), 1e-9);
  }
}

TEST(CutHandles, ACornerTurnsTheBoxAboutItsMiddle) {
  for (const scene::Projection projection : kProjections) {
    const scene::Scene scene = viewOf(projection);
    const CutStage stage = stageOf(scene);
    const scene::Clip clip = turnedBoxCut();
    const TurnedBox before = turnedBox(clip);
    for (int corner = 0; corner < 8; ++corner) {
      const CutGrip grip{0, CutPart::turn, corner};
      const glm::dvec2 from = projectedOn(stage, before.corner(corner)).pixel;
      const glm::dvec2 middle = projectedOn(stage, before.middle).pixel;
      const glm::dvec2 to = glm::mix(from, middle, 0.2) + glm::dvec2(3.0, -2.0);
      const scene::Clip turned = draggedCut(clip, grip, stage, from, to, false);
      const TurnedBox box = turnedBox(turned);
      EXPECT_EQ(turned.box, clip.box);
      EXPECT_NEAR(glm::length(turned.boxRotation), 1.0, 1e-12);
      EXPECT_LT(distanceToRay(rayOf(scene, to), box.corner(corner)), 0.05) << corner;
      const scene::Clip about = draggedCut(clip, grip, stage, from, to, true);
      int kept = 0;  // axes that stay as they are
      for (int axis = 0; axis < 3; ++axis)
        kept += glm::distance(turnedBox(about).axes[axis], before.axes[axis]) < 1e-9;
      EXPECT_EQ(kept, 1) << corner;
    }
  }
}

// Faces and corners that are seen go before those behind them; the far ones are marked.
TEST(CutHandles, WhatTheViewerSeesIsGrippedFirst) {
  scene::Scene scene = viewOf(scene::Projection::orthographic);
  scene.camera.eye = {0, -200, 0};
  scene.camera.target = {0, 0, 0};
  scene.camera.up = {0, 0, 1};
  scene::Clip clip;
  clip.box = {{-20, -10, -12}, {20, 10, 12}};
  const auto shapes = cutShapes(clip, stageOf(scene));
  EXPECT_FALSE(knob(shapes, {0, CutPart::face, 2}).far);
  EXPECT_TRUE(knob(shapes, {0, CutPart::face, 3}).far);
  const auto grip = cutAt(shapes, knob(shapes, {0, CutPart::turn, 7}).pixel);  // lies behind corner 5
  ASSERT_TRUE(grip);
  EXPECT_EQ(*grip, (CutGrip{0, CutPart::turn, 5}));
}

TEST(CutHandles, StepsGoAwayFromTheViewer) {
  const CutStage stage = stageOf(viewOf(scene::Projection::perspective));
  for (const double side : {1.0, -1.0}) {
    scene::Clip clip = onePlane();
    clip.planes[0].normal *= side;
    const scene::Clip stepped = steppedCut(clip, kMovePlane, stage, 2.0);
    const glm::dvec3 way = stepped.planes[0].point - clip.planes[0].point;
    EXPECT_NEAR(glm::length(way), 2.0, 1e-9);
    EXPECT_LT(glm::dot(way, stage.frame.back), 0.0);
  }
  const scene::Clip box = turnedBoxCut();
  EXPECT_EQ(steppedCut(box, {0, CutPart::move, 0}, stage, 2.0), box);
  EXPECT_EQ(steppedCut(box, kMovePlane, stage, 2.0), box);  // no such plane
}

// Zoomed in so that the plane's middle is off the picture, its knob is where the picture's middle sees it; an
// eye within the volume, or a plane behind it, makes no handles of nothing.
TEST(CutHandles, NothingIsEverNotANumber) {
  for (const scene::Projection projection : kProjections)
    for (const glm::dvec3& eye : {glm::dvec3(30, 20, 10), glm::dvec3(1, 0, 5), glm::dvec3(500, 2, 1)}) {
      scene::Scene scene = viewOf(projection);
      scene.camera.eye = eye;
      scene.camera.target = eye + glm::dvec3(-3, 7, 1);
      const CutStage stage = stageOf(scene);
      scene::Clip clip = turnedBoxCut();
      clip.planes = {{{3, -2, 5}, {0.6, 0.5, 2.0}}, {{-900, 0, 0}, {1, 0, 0}}, {eye, {0, 0, 1}}};
      for (const CutShape& shape : cutShapes(clip, stage)) {
        for (const CutLine& line : shape.outline)
          ASSERT_TRUE(std::isfinite(line.from.x + line.from.y + line.to.x + line.to.y));
        for (const CutKnob& one : shape.knobs) {
          ASSERT_TRUE(std::isfinite(one.pixel.x + one.pixel.y));
          for (const bool constrained : {false, true}) {
            const scene::Clip dragged =
                draggedCut(clip, one.grip, stage, one.pixel, one.pixel + glm::dvec2(150, -90), constrained);
            for (const scene::ClipPlane& plane : dragged.planes) {
              ASSERT_TRUE(std::isfinite(glm::dot(plane.point, plane.normal)));
              ASSERT_GT(glm::length(plane.normal), 1e-3);
            }
            ASSERT_TRUE(std::isfinite(glm::length(dragged.box[0]) + glm::length(dragged.boxRotation)));
          }
        }
      }
    }
  scene::Scene scene = viewOf(scene::Projection::orthographic);
  scene.camera.target = {28, 18, 5};
  scene.camera.eye = *scene.camera.target + glm::dvec3(0.0, 0.0, 12.0);
  const CutStage stage = stageOf(scene);
  const auto shapes = cutShapes(onePlane(), stage);
  ASSERT_EQ(shapes[0].knobs.size(), 2u);
  EXPECT_LT(glm::distance(shapes[0].knobs[0].pixel, 0.5 * kPixels), 1e-6);
}

}  // namespace
}  // namespace isolux::app
