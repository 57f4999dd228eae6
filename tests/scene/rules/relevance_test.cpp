// Which settings act under which look and under which choices, as tables.
#include "scene/rules/relevance.h"

#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "scene/settings/settings.h"
#include "tests/support/lamps.h"
#include "tests/support/surfaces.h"

namespace isolux::test {

namespace {

std::string activeLook(const scene::Scene& scene) {
  std::string names;
  for (const scene::Setting& setting : scene::settings()) {
    if (!setting.path.starts_with("look.") || !scene::whyInactive(setting.path, scene).empty()) continue;
    const std::string name = setting.path.substr(5);
    if (name == "mode" || name.starts_with("background")) continue;  // always act
    names += (names.empty() ? "" : " ") + name;
  }
  return names;
}

bool acts(const char* path, const scene::Scene& scene) {
  return scene::whyInactive(path, scene).empty();
}

}  // namespace

TEST(Relevance, OfEachLook) {
  // With the defaults: Lambert under colours, no strength in lines, fog, texture and flow.
  const std::string lines = "overlay ridges contours suggestive_contours";
  const std::string lambert = "shading ambient ambient_variation ";
  const std::string measure =
      lambert +
      "shadow occlusion occlusion_radius fog colormap colormap_points range_low range_high legend "
      "legend_corner accessibility " +
      lines;
  const std::map<std::string, std::string> table = {
      {"blinn_phong",
       "ambient ambient_variation specular shininess inner_tint texture shadow occlusion occlusion_radius "
       "fog accessibility " +
           lines},
      {"lambert",
       "ambient ambient_variation inner_tint texture shadow occlusion occlusion_radius fog accessibility " +
           lines},
      {"tone", "tone_cool tone_warm inner_tint texture shadow fog accessibility " + lines +
                   " contour_width contour_color"},
      {"kappa1", measure},
      {"kappa2", measure},
      {"mean_curvature", measure},
      {"gaussian_curvature", measure},
      {"shape_index", measure},
      {"curvedness", measure},
      {"flowline_curvature", measure},
      {"edge_offset", measure},
      {"curvature_2d", lambert +
                           "shadow occlusion occlusion_radius fog range_low range_high curvature_points "
                           "legend legend_corner accessibility " +
                           lines},
      {"accessibility",
       lambert + "inner_tint texture shadow occlusion occlusion_radius fog accessibility_points " + lines},
      {"flow", lambert + "inner_tint texture shadow occlusion occlusion_radius fog accessibility " + lines},
      {"gi", "inner_tint texture fog accessibility " + lines},
      {"normal", ""},
      {"curvature_direction", ""},
      {"depth", ""},
  };
  const scene::Setting& mode = scene::setting("look.mode");
  EXPECT_EQ(table.size(), mode.choices.size());
  for (const auto& [name, expected] : table) {
    scene::Scene scene;
    mode.set(scene, name);
    EXPECT_EQ(activeLook(scene), expected) << name;
  }
}

TEST(Relevance, ATransferFunctionOfYourOwnTakesThePlaceOfTheMap) {
  scene::Scene scene;
  scene.look.mode = scene::LookMode::kappa1;
  scene.look.colormapPoints = {{0.0, glm::dvec3(0.0)}, {1.0, glm::dvec3(1.0)}};
  EXPECT_EQ(scene::whyInactive("look.colormap", scene), "control points are set (look.colormap_points)");
  EXPECT_TRUE(acts("look.colormap_points", scene));
  EXPECT_FALSE(acts("look.accessibility_points", scene));
  scene.look.accessibility = 0.5;
  EXPECT_TRUE(acts("look.accessibility_points", scene));
}

TEST(Relevance, EdgesAndASecondVolumeWhereTheyAreShown) {
  scene::Scene scene;
  EXPECT_FALSE(acts("edge.search", scene));
  EXPECT_TRUE(acts("color.volume", scene));
  EXPECT_FALSE(acts("color.map", scene));
  EXPECT_FALSE(acts("look.legend", scene));
  scene.color.volume = "phantom:ball";
  EXPECT_TRUE(acts("color.map", scene));
  EXPECT_TRUE(acts("look.legend", scene));
  EXPECT_FALSE(acts("color.isoline_width", scene));
  scene.color.strength = 0.0;
  EXPECT_FALSE(acts("color.map", scene));
  EXPECT_FALSE(acts("look.legend", scene));
  scene.color.isolines = 2.0;
  EXPECT_TRUE(acts("color.isoline_width", scene));
  EXPECT_TRUE(acts("color.below", scene));
  scene.look.mode = scene::LookMode::edge_offset;
  EXPECT_FALSE(acts("color.volume", scene));
  EXPECT_TRUE(acts("edge.search", scene));
  EXPECT_TRUE(acts("derivatives.noise", scene));
  EXPECT_FALSE(acts("isosurface.ghost_opacity", scene));
  scene.surfaces.front().ghost = 1.0;
  EXPECT_TRUE(acts("isosurface.ghost_opacity", scene));
  EXPECT_TRUE(acts("isosurface.layers", scene));
}

TEST(Relevance, LightNeedsALitLook) {
  const std::set<std::string> dark = {"gi", "normal", "curvature_direction", "depth"};
  const scene::Setting& mode = scene::setting("look.mode");
  for (const std::string& name : mode.choices) {
    scene::Scene scene;
    mode.set(scene, name);
    EXPECT_EQ(acts("light.direction", scene), !dark.contains(name)) << name;
    EXPECT_EQ(acts("light.color", scene), !dark.contains(name) && name != "tone") << name;
  }
  scene::Scene unlit;
  unlit.look.mode = scene::LookMode::kappa1;
  unlit.look.shading = scene::Shading::unlit;
  EXPECT_EQ(scene::whyInactive("light.space", unlit), "only local shading uses this light");
}

TEST(Relevance, AShadowNeedsAKeyLightThatBrightens) {
  scene::Scene scene;
  EXPECT_TRUE(acts("look.shadow", scene));
  scene.light.intensity = 0.0;
  EXPECT_EQ(scene::whyInactive("look.shadow", scene), "the key light has no effect");
  scene.look.mode = scene::LookMode::tone;
  EXPECT_TRUE(acts("look.shadow", scene));
}

TEST(Relevance, ShadowsOfLightSourcesAreOfBakedLight) {
  scene::Scene scene;
  EXPECT_FALSE(acts("light.environment.shadows", scene));
  scene.look.mode = scene::LookMode::gi;
  EXPECT_TRUE(acts("light.environment.shadows", scene));
  EXPECT_EQ(scene::whyInactive("lamps.light1.shadows", scene), "there is no such item");
  lampAt(scene, 0).shown = false;
  for (const char* path : {"lamps.light1.shadows", "lamps.1.shadows", "lamp1.shadows"})
    EXPECT_EQ(scene::whyInactive(path, scene), "that light source is off") << path;
  test::lampAt(scene, 0).shown = true;
  EXPECT_TRUE(acts("lamp1.shadows", scene));
  scene.light.environment.shadows = false;
  scene.light.environment.constant = glm::dvec3(1.0);
  test::lampAt(scene, 0).shown = false;
  scene.gi.bounces = 0;
  EXPECT_TRUE(acts("light.environment.shadows", scene)) << "to switch them on again";
  EXPECT_TRUE(acts("gi.sequence", scene)) << "of reflections and of the metered light";
  EXPECT_FALSE(acts("gi.samples", scene));
  scene.gi.mode = scene::GiMode::off;
  EXPECT_EQ(scene::whyInactive("light.environment.shadows", scene), "no light is baked");
}

TEST(Relevance, StrengthsBringTheirDetails) {
  scene::Scene scene;
  for (const char* path : {"look.ridge_threshold", "look.ridge_width", "look.ridge_width_unit",
                           "look.ridge_length", "look.contour_width", "look.fog_color", "flow.length",
                           "look.texture_scale", "derivatives.noise", "isosurface.layers"})
    EXPECT_FALSE(acts(path, scene)) << path;
  scene.look.ridges = scene.look.suggestiveContours = scene.look.fog = scene.flow.strength = 0.1;
  scene.look.texture = scene::SolidTexture::marble;
  scene.surfaces.front().opacity = 0.5;
  for (const char* path : {"look.ridge_threshold", "look.ridge_width", "look.ridge_width_unit",
                           "look.ridge_length", "look.contour_width", "look.fog_color", "flow.length",
                           "look.texture_scale", "derivatives.noise", "isosurface.layers"})
    EXPECT_TRUE(acts(path, scene)) << path;
  EXPECT_TRUE(scene::showsFlow(scene));
  scene.look.mode = scene::LookMode::normal;  // nothing is laid over a raw quantity
  for (const char* path : {"look.ridge_threshold", "look.ridge_width", "look.ridge_width_unit",
                           "look.ridge_length", "look.contour_width", "look.fog_color", "flow.length"})
    EXPECT_FALSE(acts(path, scene)) << path;
}

TEST(Relevance, HitsIsosurfacesAndSources) {
  scene::Scene scene;
  EXPECT_EQ(scene::whyInactive("hit.rate", scene), "hits are exact");
  EXPECT_FALSE(acts("isosurface3.value", scene));
  EXPECT_TRUE(acts("isosurface3.shown", scene));
  EXPECT_FALSE(acts("source.csg_path", scene));
  EXPECT_FALSE(acts("source.mesh_voxels", scene));
  scene.hit.method = scene::HitMethod::sampled;
  test::surfaceAt(scene, 2).shown = true;
  scene.source.csg = scene::Csg::blend;
  EXPECT_TRUE(acts("source.csg_weight", scene));
  scene.source.csg = scene::Csg::unite;
  EXPECT_FALSE(acts("source.csg_weight", scene));
  scene.source.path = "/scans/Skull.STL";
  EXPECT_TRUE(acts("hit.rate", scene));
  EXPECT_TRUE(acts("isosurface3.value", scene));
  EXPECT_TRUE(acts("source.csg_path", scene));
  EXPECT_TRUE(acts("source.mesh_voxels", scene));
}

TEST(Relevance, PiecesNeedASurface) {
  scene::Scene scene;
  EXPECT_TRUE(acts("pieces.keep", scene));
  scene.surfaces.front().opacity = 0.0;
  for (const char* path : {"pieces.keep", "pieces.smallest", "pieces.hidden", "pieces.only", "pieces.within"})
    EXPECT_FALSE(acts(path, scene)) << path;
  test::surfaceAt(scene, 1).shown = true;
  EXPECT_TRUE(acts("pieces.keep", scene));
  test::surfaceAt(scene, 1).opacity = 0.0;
  EXPECT_FALSE(acts("pieces.keep", scene));
  // Which side is inside says whose pieces are chosen, whatever the look.
  scene = {};
  scene.look.mode = scene::LookMode::depth;
  EXPECT_FALSE(acts("isosurface.inside", scene));
  scene.pieces.keep = 1;
  EXPECT_TRUE(acts("isosurface.inside", scene));
  EXPECT_FALSE(acts("pieces.depth", scene));
  scene.pieces.within = 0.0;
  EXPECT_TRUE(acts("pieces.depth", scene));
}

}  // namespace isolux::test
