// Which plane a view shows, and where planes meet: against closed forms.
#include "app/slices/slice_choice.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "app/cuts/cut_edits.h"
#include "app/slices/slice_content.h"
#include "tests/support/volumes.h"

namespace isolux::test {
namespace {

using app::SliceChoice;
using volume::SliceDirection;
constexpr auto axes = scene::WorldAxes::anatomical;

scene::Scene withCut(glm::dvec3 point, glm::dvec3 normal) {
  scene::Scene scene;
  scene.clip.planes.push_back({point, normal});
  return scene;
}

TEST(SliceChoice, AStraightPlanePassesThroughTheCrosshairAlone) {
  const auto geometry = unitGeometry({21, 31, 41});
  scene::Scene scene;
  scene.slice.position = glm::dvec3(3.0, 7.0, 11.0);
  for (const auto direction : {SliceDirection::axial, SliceDirection::coronal, SliceDirection::sagittal}) {
    const auto plane = app::chosenPlane({.direction = direction}, scene, geometry, axes);
    ASSERT_TRUE(plane);
    glm::dvec3 expected(10.0, 15.0, 20.0);
    expected[volume::axisOf(direction)] = (*scene.slice.position)[volume::axisOf(direction)];
    EXPECT_EQ(plane->pointMm, expected);
  }
}

TEST(SliceChoice, AnObliqueOneIsThatOfItsNormalThroughTheCrosshair) {
  const auto geometry = unitGeometry({21, 31, 41});
  scene::Scene scene;
  scene.slice.position = glm::dvec3(3.0, 7.0, 11.0);
  const SliceChoice choice{.kind = SliceChoice::Kind::oblique, .normal = {1.0, 2.0, 3.0}};
  const auto plane = app::chosenPlane(choice, scene, geometry, axes);
  ASSERT_TRUE(plane);
  const glm::dvec3 normal = glm::normalize(choice.normal);
  EXPECT_NEAR(std::abs(glm::dot(plane->normal(), normal)), 1.0, 1e-12);
  EXPECT_NEAR(glm::dot(plane->pointMm - *scene.slice.position, normal), 0.0, 1e-12);
  EXPECT_FALSE(app::chosenPlane({.kind = SliceChoice::Kind::oblique, .normal = {}}, scene, geometry, axes));
}

TEST(SliceChoice, ACutShowsItsPlaneWhereverTheCrosshairIs) {
  const auto geometry = unitGeometry({21, 31, 41});
  scene::Scene scene = withCut({5.0, 6.0, 7.0}, {0.0, 3.0, 4.0});
  const SliceChoice first{.kind = SliceChoice::Kind::cut}, second{.kind = SliceChoice::Kind::cut, .cut = 1};
  const auto plane = app::chosenPlane(first, scene, geometry, axes);
  ASSERT_TRUE(plane);
  EXPECT_NEAR(std::abs(glm::dot(plane->normal(), {0.0, 0.6, 0.8})), 1.0, 1e-12);
  EXPECT_NEAR(glm::dot(plane->pointMm - glm::dvec3(5.0, 6.0, 7.0), {0.0, 0.6, 0.8}), 0.0, 1e-12);
  scene.slice.position = glm::dvec3(1.0, 1.0, 1.0);
  EXPECT_EQ(app::chosenPlane(first, scene, geometry, axes)->pointMm, plane->pointMm);
  EXPECT_FALSE(app::chosenPlane(second, scene, geometry, axes)) << "there is one cut only";
}

TEST(SliceChoice, AStepMovesByAVoxelAndStaysInTheVolume) {
  volume::GridGeometry geometry = unitGeometry({21, 31, 41});
  geometry.worldFromVoxel[2][2] = 2.5;
  const scene::Scene scene;
  const glm::dvec3 middle = app::slicePosition(scene, geometry);
  scene::Scene edited = scene;
  app::stepPlane(edited, {}, scene, geometry, axes, 2.0);
  ASSERT_TRUE(edited.slice.position);
  EXPECT_EQ(*edited.slice.position, middle + glm::dvec3(0.0, 0.0, 5.0));
  app::stepPlane(edited, {.direction = SliceDirection::sagittal}, scene, geometry, axes, 1e6);
  EXPECT_EQ(edited.slice.position->x, 20.0);
}

TEST(SliceChoice, AStepOfACutMovesTheCut) {
  const auto geometry = unitGeometry({21, 31, 41});
  const scene::Scene scene = withCut({5.0, 6.0, 7.0}, {0.0, 0.0, -2.0});
  scene::Scene edited = scene;
  app::stepPlane(edited, {.kind = SliceChoice::Kind::cut}, scene, geometry, axes, 3.0);
  EXPECT_NEAR(glm::distance(edited.clip.planes[0].point, {5.0, 6.0, 10.0}), 0.0, 1e-12);
  EXPECT_EQ(edited.clip.planes[0].normal, scene.clip.planes[0].normal);
  EXPECT_FALSE(edited.slice.position);
}

TEST(SliceChoice, PlanesCrossWhereBothHold) {
  const auto geometry = unitGeometry({21, 31, 41});
  scene::Scene scene = withCut({5.0, 6.0, 7.0}, {1.0, 2.0, 0.5});
  scene.slice.position = glm::dvec3(3.0, 7.0, 11.0);
  const auto coronal = app::chosenPlane({.direction = SliceDirection::coronal}, scene, geometry, axes);
  const auto picture = volume::fittedSlice(geometry, coronal->frame, coronal->pointMm, {300, 280});
  const auto cut = app::chosenPlane({.kind = SliceChoice::Kind::cut}, scene, geometry, axes);
  const auto line = app::crossingLine(picture, *cut);
  ASSERT_TRUE(line);
  for (const glm::dvec2& end : *line) {
    const glm::dvec3 world = picture.at(end);
    EXPECT_NEAR(world.y, 7.0, 1e-9);
    EXPECT_NEAR(glm::dot(world - cut->pointMm, cut->normal()), 0.0, 1e-9);
    const bool onBorder = std::abs(end.x + 0.5) < 1e-6 || std::abs(end.x - 299.5) < 1e-6 ||
                          std::abs(end.y + 0.5) < 1e-6 || std::abs(end.y - 279.5) < 1e-6;
    EXPECT_TRUE(onBorder) << end.x << ' ' << end.y;
  }
  EXPECT_FALSE(app::crossingLine(picture, *coronal)) << "parallel";
}

// A diagonal plane through the middle of a cube cuts out the regular hexagon of side a / sqrt(2).
TEST(SliceChoice, TheOutlineOfADiagonalPlaneIsAHexagon) {
  const auto geometry = unitGeometry(glm::ivec3(11));
  const scene::Scene scene = withCut(glm::dvec3(5.0), {1.0, 1.0, 1.0});
  const auto plane = app::chosenPlane({.kind = SliceChoice::Kind::cut}, scene, geometry, axes);
  const auto outline = app::outlineOf({plane->pointMm, plane->normal()}, geometry.corners());
  ASSERT_EQ(outline.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(glm::distance(outline[i], outline[(i + 1) % 6]), 10.0 / std::sqrt(2.0), 1e-9);
  const scene::Scene beside = withCut(glm::dvec3(50.0), {1.0, 1.0, 1.0});
  const auto missing = app::chosenPlane({.kind = SliceChoice::Kind::cut}, beside, geometry, axes);
  EXPECT_TRUE(app::outlineOf({missing->pointMm, missing->normal()}, geometry.corners()).empty());
}

}  // namespace
}  // namespace isolux::test
