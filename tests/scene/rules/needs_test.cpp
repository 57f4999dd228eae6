// What a scene's look needs and shows, at the borders between one look and the next.
#include "scene/rules/needs.h"

#include <set>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "scene/rules/automatic.h"
#include "scene/settings/settings.h"
#include "tests/support/surfaces.h"

namespace isolux::test {

namespace {

std::set<std::string> looksWith(bool (*holds)(const scene::Scene&)) {
  const scene::Setting& mode = scene::setting("look.mode");
  std::set<std::string> names;
  for (const std::string& name : mode.choices) {
    scene::Scene scene;
    mode.set(scene, name);
    if (holds(scene)) names.insert(name);
  }
  return names;
}

using Names = std::set<std::string>;

}  // namespace

TEST(Needs, OfEachLook) {
  const Names measures = {"kappa1",     "kappa2",       "mean_curvature", "gaussian_curvature", "shape_index",
                          "curvedness", "curvature_2d", "edge_offset",    "flowline_curvature"};
  EXPECT_EQ(looksWith([](const scene::Scene& s) { return scene::isMeasure(s.look.mode); }), measures);
  EXPECT_EQ(looksWith(scene::showsLegend), measures);
  Names coloured = measures;
  coloured.insert({"accessibility", "flow"});
  EXPECT_EQ(looksWith([](const scene::Scene& s) { return scene::isColored(s.look.mode); }), coloured);
  Names curved = coloured;
  curved.erase("edge_offset");
  curved.insert({"tone", "curvature_direction"});  // outlines of tone
  EXPECT_EQ(looksWith(scene::needsCurvature), curved);
  EXPECT_EQ(looksWith(scene::needsEdge), Names{"edge_offset"});
  EXPECT_EQ(looksWith(scene::isPlain), (Names{"normal", "curvature_direction", "depth"}));
  EXPECT_EQ(looksWith(scene::showsFlow), Names{"flow"});
  EXPECT_EQ(looksWith(scene::usesGi), Names{"gi"});
  EXPECT_EQ(looksWith([](const scene::Scene& s) { return !scene::needsGradient(s); }), Names{"depth"});
}

TEST(Needs, ToneHasOutlinesUnlessToldOtherwise) {
  scene::Scene scene;
  EXPECT_EQ(scene::contoursOf(scene), 0.0);
  scene.look.mode = scene::LookMode::tone;
  EXPECT_EQ(scene::contoursOf(scene), 0.5);
  EXPECT_EQ(scene::resolve(scene, {}).look.contours, 0.5);
  scene.look.contours = 0.0;
  EXPECT_EQ(scene::contoursOf(scene), 0.0);
  scene.look.mode = scene::LookMode::shape_index;
  scene.look.shading = scene::Shading::tone;
  scene.look.contours.reset();
  EXPECT_EQ(scene::contoursOf(scene), 0.5);
}

TEST(Needs, NothingIsLaidOverARawQuantity) {
  for (const auto mode : {scene::LookMode::normal, scene::LookMode::depth}) {
    scene::Scene scene;
    scene.look.mode = mode;
    scene.look.ridges = scene.look.accessibility = scene.flow.strength = 1.0;
    scene.look.contours = 1.0;
    EXPECT_FALSE(scene::drawsLines(scene));
    scene.look.shadow = 1.0;
    EXPECT_FALSE(scene::needsCurvature(scene));
    EXPECT_FALSE(scene::showsFlow(scene));
    EXPECT_FALSE(scene::showsShadow(scene));
  }
}

TEST(Needs, TrilinearExactHitsMayBeRefinedAtRest) {
  scene::Scene scene;
  EXPECT_TRUE(scene::mayRefineHits(scene));
  for (const auto change : {+[](scene::Scene& s) { s.picture.restHits = scene::StillField::same; },
                            +[](scene::Scene& s) { s.hit.method = scene::HitMethod::sampled; },
                            +[](scene::Scene& s) { s.hit.field = scene::Field::cubic; },
                            +[](scene::Scene& s) { s.look.mode = scene::LookMode::gi; }}) {
    scene::Scene other = scene;
    change(other);
    EXPECT_FALSE(scene::mayRefineHits(other));
  }
}

TEST(Needs, ASurfaceOfOpacity0IsNotThereNorTransparent) {
  scene::Scene scene;
  EXPECT_FALSE(scene::isTransparent(scene));
  scene.surfaces.front().opacity = 0.0;
  EXPECT_FALSE(scene::isTransparent(scene));
  test::surfaceAt(scene, 2).opacity = 0.5;
  EXPECT_FALSE(scene::isTransparent(scene));  // not shown
  test::surfaceAt(scene, 2).shown = true;
  EXPECT_TRUE(scene::isTransparent(scene));
  test::surfaceAt(scene, 2).opacity = 0.0;
  scene.surfaces.front().opacity = 0.99;
  EXPECT_TRUE(scene::isTransparent(scene));
}

}  // namespace isolux::test
