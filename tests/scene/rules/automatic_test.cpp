// Where further isosurfaces lie that nobody has placed.
#include "scene/rules/automatic.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "scene/camera.h"
#include "tests/support/surfaces.h"

namespace isolux::scene {
namespace {

VolumeFacts factsOf(std::vector<double> suggestions, double suggested, double minimum, double maximum) {
  VolumeFacts facts;
  facts.boundsMaxMm = glm::dvec3(100.0);
  facts.suggestedIsovalue = suggested;
  facts.suggestedIsovalues = std::move(suggestions);
  facts.minimum = minimum;
  facts.maximum = maximum;
  return facts;
}

TEST(Automatic, AFurtherSurfaceLiesOutsideTheFirstWhereTheHistogramSuggestsOne) {
  const VolumeFacts ct = factsOf({-300.0, 300.0}, -300.0, -1024.0, 3071.0);
  const VolumeFacts classes = factsOf({20.0, 60.0, 130.0}, 60.0, 0.0, 255.0);
  const VolumeFacts nothing = factsOf({50.0}, 50.0, 0.0, 250.0);
  struct Case {
    const char* what;
    const VolumeFacts& facts;
    std::optional<double> first;
    Inside inside;
    double second;
  };
  for (const Case& one : {Case{"skin around bone", ct, 300.0, Inside::above, -300.0},
                          {"around what is about bone", ct, 226.0, Inside::above, -300.0},
                          {"around teeth comes bone", ct, 1700.0, Inside::above, 300.0},
                          {"skin has nothing around it: bone within", ct, {}, Inside::above, 300.0},
                          {"about skin is skin", ct, -250.0, Inside::above, 300.0},
                          {"the nearest outside", classes, 130.0, Inside::above, 60.0},
                          {"outside is above where inside is below", classes, 60.0, Inside::below, 130.0},
                          {"the last one, inside below: within", classes, 130.0, Inside::below, 60.0},
                          {"no suggestion: a quarter of the way in", nothing, {}, Inside::above, 100.0},
                          {"a quarter of the way in, below", nothing, {}, Inside::below, 37.5}}) {
    SCOPED_TRACE(one.what);
    Scene scene;
    scene.surfaces.front().value = one.first;
    scene.isosurface.inside = one.inside;
    test::surfaceAt(scene, 1).shown = true;
    EXPECT_EQ(resolve(scene, one.facts).surfaces.at(1).value, one.second);
  }
}

// Each of several takes a suggestion of its own; those that are not shown take none away.
TEST(Automatic, FurtherSurfacesShareNoSuggestion) {
  const VolumeFacts facts = factsOf({20.0, 60.0, 130.0}, 130.0, 0.0, 255.0);
  Scene scene;
  test::surfaceAt(scene, 2).shown = test::surfaceAt(scene, 3).shown = true;
  Scene resolved = resolve(scene, facts);
  EXPECT_EQ(resolved.surfaces.at(2).value, 60.0);
  EXPECT_EQ(resolved.surfaces.at(3).value, 20.0);
  test::surfaceAt(scene, 3).value = 61.0;  // given: takes 60 away
  resolved = resolve(scene, facts);
  EXPECT_EQ(resolved.surfaces.at(2).value, 20.0);
  EXPECT_EQ(resolved.surfaces.at(3).value, 61.0);
}

// A ball's outline beside the middle of the box.
VolumeFacts factsWithOutline() {
  VolumeFacts facts = factsOf({50.0}, 50.0, 0.0, 250.0);
  facts.contrastIsovalue = 120.0;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      glm::dvec3 point(20.0);
      point[axis] += sign * 10.0;
      facts.outlineMm.push_back(point);
    }
  facts.toEye = glm::normalize(glm::dvec3(1, -1, 1));
  facts.up = {0, 0, 1};
  return facts;
}

TEST(Automatic, ACameraFramesTheOutlineFromItsSide) {
  const VolumeFacts facts = factsWithOutline();
  const Camera camera = resolve(Scene{}, facts).camera;
  EXPECT_LT(glm::distance(*camera.target, glm::dvec3(20.0)), 2.0);
  EXPECT_GT(glm::dot(glm::normalize(*camera.eye - *camera.target), facts.toEye), 1.0 - 1e-9);
  const double tangent = std::tan(glm::radians(0.5 * camera.fov));
  EXPECT_LT(glm::distance(*camera.eye, *camera.target) * tangent, 13.0) << "10 mm fill half of the height";
  const Camera again = framed(camera, facts);
  EXPECT_LT(glm::distance(*again.eye, *camera.eye) + glm::distance(*again.target, *camera.target), 1e-9);
  const Camera wide = fittedTo(camera, facts, [&] { return Rooms{wholePicture(0.5)}; });
  EXPECT_GT(glm::distance(*wide.eye, *wide.target), 1.5 * glm::distance(*camera.eye, *camera.target));
  Scene chosen;
  chosen.camera = zoomed(camera, 1.5);
  const auto unasked = []() -> Rooms {
    ADD_FAILURE() << "rooms take long to find";
    return {};
  };
  EXPECT_EQ(fittedTo(chosen.camera, facts, unasked), chosen.camera) << "somebody has chosen it";
}

TEST(Automatic, OfSessionsOfBeforeIsAsItWas) {
  VolumeFacts facts = factsWithOutline();
  Scene before;
  before.camera.frames = Frames::volume;
  before.isosurface.suggestion = Suggestion::contrast;
  const Scene resolved = resolve(before, facts);
  EXPECT_EQ(resolved.surfaces.front().value, 120.0);
  EXPECT_EQ(resolve(Scene{}, facts).surfaces.front().value, 50.0);
  EXPECT_EQ(*resolved.camera.target, glm::dvec3(50.0)) << "the middle of the box";
  facts.outlineMm.clear();
  Camera front = resolve(Scene{}, facts).camera;
  front.frames = Frames::volume;
  EXPECT_EQ(front, resolved.camera) << "as where no outline is known";
}

}  // namespace
}  // namespace isolux::scene
