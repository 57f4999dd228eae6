// scene/rules/relevance.h against what the passes depend on: a setting that is said to do nothing changes no
// pass.
#include "scene/rules/relevance.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "render/passes/pass_declarations.h"
#include "scene/settings/settings.h"
#include "tests/scene/random_scene.h"
#include "tests/support/surfaces.h"

namespace isolux::test {

namespace {

using nlohmann::json;

// A value that differs from the scene's.
json otherValue(const scene::Setting& s, const scene::Scene& scene) {
  const json now = s.get(scene);
  const double low = std::max(s.minimum, -1e3), high = std::min(s.maximum, 1e3);
  switch (s.type) {
    case scene::SettingType::number:
      return now == low + 0.371 * (high - low) ? low + 0.5 * (high - low) : low + 0.37123 * (high - low);
    case scene::SettingType::integer:
      return now == s.minimum + 1 ? s.minimum + 2 : s.minimum + 1;
    case scene::SettingType::choice:
      return now == s.choices.back() ? s.choices.front() : s.choices.back();
    case scene::SettingType::vector:
      return {0.25, 0.5, 0.125};
    case scene::SettingType::pair:
      return {0.25, 0.5};
    case scene::SettingType::quaternion:
      return {0.25, 0.5, 0.125, 0.75};
    case scene::SettingType::toggle:
      return !now.get<bool>();
    case scene::SettingType::points:
      return json::array({{0.5, -0.5, 0.25, 0.5, 1.0}});
    case scene::SettingType::color_points:
      return json::array({{0.0, 0.25, 0.5, 1.0}, {1.0, 1.0, 0.5, 0.25}});
    case scene::SettingType::planes:
      return json::array({{1.0, -2.5, 3.0, 0.0, 0.6, -0.8}});
    case scene::SettingType::marks:
      return json::array({{{"kind", "point"}, {"name", "a"}, {"points", {{1.0, -2.5, 3.0}}}}});
    case scene::SettingType::positions:
      return json::array({{1.0, -2.5, 3.0}, {4.0, 5.0, 6.0}});
    case scene::SettingType::item:
    case scene::SettingType::ids:
    case scene::SettingType::text:
      break;
  }
  return "other";
}

// All that the passes of a picture depend on, as text; without those that nobody reads.
std::string declared(const scene::Scene& scene) {
  const std::vector<render::PassDeclaration> passes = render::declarePasses(scene, {}, 1);
  std::string text;
  for (const render::PlannedPass& planned :
       render::FrameGraph().plan(passes, render::wantedImages({}, scene))) {
    if (planned.state == render::PassState::skipped) continue;
    const render::PassDeclaration& pass = passes[planned.index];
    text += pass.name;
    for (const auto& image : pass.reads) text += " <" + image;
    for (const auto& image : pass.writes) text += " >" + image;
    for (const auto& parameter : pass.parameters)
      text += ' ' + parameter.name + '=' + std::to_string(parameter.hash);
    text += '\n';
  }
  return text;
}

// Scenes of every look, plain and with everything laid over it.
std::vector<scene::Scene> scenes() {
  std::vector<scene::Scene> result;
  const scene::Setting& mode = scene::setting("look.mode");
  for (const std::string& name : mode.choices) {
    for (int variant = 0; variant < 4; ++variant) {
      scene::Scene scene;
      mode.set(scene, name);
      scene.surfaces.front().value = 1.0;
      scene.flow.time = 0.3;
      if (variant == 1) {
        scene.look.ridges = scene.look.fog = scene.flow.strength = 0.5;
        scene.look.contours = 0.5;
        scene.look.shadow = scene.look.accessibility = 0.5;
        scene.look.texture = scene::SolidTexture::wood;
        scene.hit.method = scene::HitMethod::sampled;
      } else if (variant == 2) {
        scene.look.shading = scene::Shading::unlit;
        test::surfaceAt(scene, 2).shown = true;
        test::surfaceAt(scene, 2).opacity = 1.0;
        scene.derivatives.field = scene::Field::trilinear;
      } else if (variant == 3) {
        scene.look.shading = scene::Shading::tone;
        scene.look.specular = 0.0;
      }
      result.push_back(scene);
    }
  }
  return result;
}

}  // namespace

TEST(RelevanceOfPasses, WhatDoesNothingChangesNoPass) {
  for (const scene::Scene& scene : scenes()) {
    const std::string before = declared(scene);
    for (const scene::Setting& setting : everySetting(scene)) {
      const std::string_view why = scene::whyInactive(setting.path, scene);
      if (why.empty()) continue;
      scene::Scene changed = scene;
      setting.set(changed, otherValue(setting, scene));
      EXPECT_EQ(declared(changed), before)
          << setting.path << " in look " << scene::setting("look.mode").get(scene) << ", although " << why;
    }
  }
}

TEST(RelevanceOfPasses, WhatActsOnALookChangesAPass) {
  for (const scene::Scene& scene : scenes()) {
    const std::string before = declared(scene);
    for (const scene::Setting& setting : everySetting(scene)) {
      const std::string group = setting.path.substr(0, setting.path.find('.'));
      if (group != "look" && group != "flow" && group != "light" && group != "isosurface" &&
          group != "surfaces")
        continue;
      if (setting.path == "flow.animate") continue;   // the window's: it moves flow.time
      if (setting.path.ends_with(".name")) continue;  // what lists say
      // These reach the renderer as another gi::PictureLight (render::LightState).
      if (setting.path.starts_with("light.environment.") || setting.path.ends_with(".specular")) continue;
      // Local light is the same on either side; light that is stored is not, nor what the histogram shows.
      const bool seesSides = scene::needsCurvature(scene) || scene.look.mode == scene::LookMode::normal;
      if (setting.path == "isosurface.inside" && !seesSides) continue;
      if (!scene::whyInactive(setting.path, scene).empty()) continue;
      scene::Scene changed = scene;
      setting.set(changed, otherValue(setting, scene));
      EXPECT_NE(declared(changed), before)
          << setting.path << " in look " << scene::setting("look.mode").get(scene);
    }
  }
}

}  // namespace isolux::test
