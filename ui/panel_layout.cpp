#include "ui/panel_layout.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "ui/number_text.h"

namespace isolux::ui {

namespace {

struct GroupPlan {
  const char* title;
  bool open;
  std::vector<std::string_view> paths;  // "group." takes what is left of a prefix
};

// What a user reaches for first comes first.
const std::vector<GroupPlan>& plan() {
  static const std::vector<GroupPlan> groups = {
      {"Look",
       true,
       {"look.mode", "look.shading", "look.ambient", "look.ambient_variation", "look.specular",
        "look.shininess", "look.tone_cool", "look.tone_warm", "look.accessibility", "look."}},
      {"Colour map",
       true,
       {"look.colormap", "look.curvature_points", "look.range_low", "look.range_high", "look.legend"}},
      {"Lines",
       true,
       {"look.contours", "look.suggestive_contours", "look.contour_width", "look.contour_color",
        "look.ridges", "look.ridge_threshold", "look.ridge_color", "look.valley_color"}},
      {"Flow", true, {"flow.strength", "flow.animate", "flow.speed", "flow."}},
      {"Light", true, {"light.", "look.shadow"}},
      {"Texture and fog", false, {"look.texture", "look.texture_scale", "look.fog", "look.fog_color"}},
      {"Isosurface", true, {"isosurface."}},
      {"More isosurfaces", false, {"isosurface2.", "isosurface3.", "isosurface4."}},
      {"Hit", false, {"hit."}},
      {"Derivatives", false, {"derivatives."}},
      {"Camera", false, {"camera."}},
      {"Picture", false, {"look.background_top", "look.background_bottom", "picture."}},
      {"Memory", false, {"memory."}},
  };
  return groups;
}

// In the volume panel, which knows the choices the file offers.
constexpr std::string_view elsewhere = "source.";

std::string prefixOf(const scene::Setting& setting) {
  return setting.path.substr(0, setting.path.find('.') + 1);
}

}  // namespace

std::vector<PanelGroup> panelGroups() {
  std::set<std::string_view> named{elsewhere};
  for (const GroupPlan& group : plan()) named.insert(group.paths.begin(), group.paths.end());
  std::vector<PanelGroup> result;
  for (const GroupPlan& group : plan()) {
    PanelGroup& made = result.emplace_back(PanelGroup{group.title, group.open, {}});
    for (const std::string_view path : group.paths)
      for (const scene::Setting& setting : scene::settings())
        if (setting.path == path || (prefixOf(setting) == path && !named.contains(setting.path)))
          made.settings.push_back(&setting);
  }
  for (const scene::Setting& setting : scene::settings()) {
    const std::string prefix = prefixOf(setting);
    if (named.contains(setting.path) || named.contains(prefix)) continue;
    const QString title = wordsOf(QString::fromStdString(prefix).chopped(1));
    auto found = std::find_if(result.begin(), result.end(), [&](const auto& g) { return g.title == title; });
    if (found == result.end()) found = result.insert(result.end(), {title, false, {}});
    found->settings.push_back(&setting);
  }
  return result;
}

RowLabel labelOf(const scene::Setting& setting) {
  const QString path = QString::fromStdString(setting.path), name = path.section('.', 1);
  // The further isosurfaces share a group: a check box for each, its details below it.
  if (path.startsWith("isosurface") && path[10].isDigit()) {
    if (name == "shown") return {QString("Isosurface ") + path[10], false};
    return {name == "albedo" ? QString("Colour") : wordsOf(name), true};
  }
  if (name == "albedo") return {"Colour", false};
  if (path == "look.curvature_points") return {"Colours of κ₁ and κ₂", false};
  if (path == "memory.gpu_budget_mb") return {"GPU budget", false};
  QString words = wordsOf(name);
  words.replace("color", "colour").replace("Color", "Colour");
  if (words == "Colourmap") words = "Colour map";
  return {words, false};
}

}  // namespace isolux::ui
