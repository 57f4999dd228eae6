// Where further isosurfaces lie that nobody has placed.
#include "scene/rules/automatic.h"

#include <gtest/gtest.h>

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
    scene.isosurface.value = one.first;
    scene.isosurface.inside = one.inside;
    scene.extraIsosurfaces[0].shown = true;
    EXPECT_EQ(resolve(scene, one.facts).extraIsosurfaces[0].value, one.second);
  }
}

// Each of several takes a suggestion of its own; those that are not shown take none away.
TEST(Automatic, FurtherSurfacesShareNoSuggestion) {
  const VolumeFacts facts = factsOf({20.0, 60.0, 130.0}, 130.0, 0.0, 255.0);
  Scene scene;
  scene.extraIsosurfaces[1].shown = scene.extraIsosurfaces[2].shown = true;
  Scene resolved = resolve(scene, facts);
  EXPECT_EQ(resolved.extraIsosurfaces[1].value, 60.0);
  EXPECT_EQ(resolved.extraIsosurfaces[2].value, 20.0);
  scene.extraIsosurfaces[2].value = 61.0;  // given: takes 60 away
  resolved = resolve(scene, facts);
  EXPECT_EQ(resolved.extraIsosurfaces[1].value, 20.0);
  EXPECT_EQ(resolved.extraIsosurfaces[2].value, 61.0);
}

}  // namespace
}  // namespace isolux::scene
