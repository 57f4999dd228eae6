#include "ui/panels/panel_layout.h"

#include <algorithm>
#include <string_view>

#include <QObject>
#include <nlohmann/json.hpp>

#include "ui/language/number_text.h"
#include "ui/language/translated.h"

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
      {QT_TRANSLATE_NOOP("QObject", "Look"),
       true,
       {"look.mode", "look.shading", "look.ambient", "look.ambient_variation", "look.specular",
        "look.shininess", "look.tone_cool", "look.tone_warm", "look.accessibility",
        "look.accessibility_points", "look."}},
      {QT_TRANSLATE_NOOP("QObject", "Colour map"),
       true,
       {"look.colormap", "look.colormap_points", "look.curvature_points", "look.range_low", "look.range_high",
        "look.legend", "look.legend_corner"}},
      {QT_TRANSLATE_NOOP("QObject", "Lines"),
       true,
       {"look.contours", "look.suggestive_contours", "look.contour_width", "look.contour_color",
        "look.ridges", "look.ridge_threshold", "look.ridge_width", "look.ridge_width_unit",
        "look.ridge_length", "look.ridge_color", "look.valley_color"}},
      {QT_TRANSLATE_NOOP("QObject", "Flow"), true, {"flow.strength", "flow.animate", "flow.speed", "flow."}},
      {QT_TRANSLATE_NOOP("QObject", "Light"),
       true,
       {"light.", "look.shadow", "look.occlusion", "look.occlusion_radius"}},
      {environmentGroup,
       true,
       {"light.environment.builtin", "light.environment.azimuth", "light.environment.elevation",
        "light.environment.exposure", "light.environment.visible", "light.environment.file",
        "light.environment.constant", "light.environment.rotation", "light.environment.moves",
        "light.environment."}},
      {QT_TRANSLATE_NOOP("QObject", "Lights"), true, {"lamps."}},
      {QT_TRANSLATE_NOOP("QObject", "Global illumination"),
       true,
       {"picture.exposure", "picture.metering", "picture.curve", "gi.ground", "gi.mode", "gi.samples",
        "gi.bounces", "gi.extent", "gi.band", "gi.texels", "gi.lattice_scale", "gi.interpolation", "gi."}},
      {QT_TRANSLATE_NOOP("QObject", "Texture and fog"),
       false,
       {"look.texture", "look.texture_scale", "look.fog", "look.fog_color"}},
      {QT_TRANSLATE_NOOP("QObject", "Isosurfaces"),
       true,
       {"isosurface.inside", "isosurface.albedo_source", "isosurface.albedo_map", "isosurface.albedo_low",
        "isosurface.albedo_high", "isosurface.", "surfaces."}},
      {QT_TRANSLATE_NOOP("QObject", "Cut"), false, {"clip."}},
      {QT_TRANSLATE_NOOP("QObject", "Hit finding"), false, {"hit."}},
      {QT_TRANSLATE_NOOP("QObject", "Derivatives"), false, {"derivatives."}},
      {QT_TRANSLATE_NOOP("QObject", "Camera"), false, {"camera."}},
      {QT_TRANSLATE_NOOP("QObject", "Image"),
       false,
       {"look.background_top", "look.background_bottom", "picture."}},
  };
  return groups;
}

// In panels of their own: the volume's, which knows the choices the file offers, and the marks'.
constexpr std::string_view elsewhere[] = {"source.", "marks."};

std::string prefixOf(const scene::Setting& setting) {
  return setting.path.substr(0, setting.path.find('.') + 1);
}

// The entry that names most of a setting's path: all of it, or a prefix ("light.environment."); empty: none.
std::string_view entryOf(const scene::Setting& setting) {
  std::string_view best;
  const auto consider = [&](std::string_view entry) {
    if (scene::covers(entry, setting.path) && entry.size() > best.size()) best = entry;
  };
  for (const std::string_view entry : elsewhere) consider(entry);
  for (const GroupPlan& group : plan())
    for (const std::string_view entry : group.paths) consider(entry);
  return best;
}

QString environmentLabel(const QString& name) {
  if (name == "file") return QObject::tr("Environment map");
  if (name == "constant") return QObject::tr("Sky colour");
  if (name == "builtin") return QObject::tr("Built-in light");
  if (name == "visible") return QObject::tr("Show as background");
  if (name == "moves") return QObject::tr("Rotatable");
  return wordsOf(name);
}

}  // namespace

std::vector<PanelGroup> panelGroups() {
  std::vector<PanelGroup> result;
  for (const GroupPlan& group : plan()) {
    PanelGroup& made = result.emplace_back(PanelGroup{group.title, group.open, {}});
    for (const std::string_view entry : group.paths) {
      for (const scene::Setting& setting : scene::settings())
        if (entryOf(setting) == entry) made.settings.push_back(setting);
      for (const scene::SceneList& list : scene::sceneLists())
        if (list.path + '.' == entry) made.list = &list;
    }
  }
  for (const scene::Setting& setting : scene::settings()) {
    if (!entryOf(setting).empty()) continue;
    const QString title = plainWordsOf(QString::fromStdString(prefixOf(setting)).chopped(1));
    auto found = std::find_if(result.begin(), result.end(), [&](const auto& g) { return g.title == title; });
    if (found == result.end()) found = result.insert(result.end(), {title, false, {}});
    found->settings.push_back(setting);
  }
  return result;
}

RowLabel labelOf(const scene::SettingInfo& setting) {
  const QString path = QString::fromStdString(setting.path), name = path.section('.', 1);
  if (scene::listOfPath(setting.path) != nullptr) {  // a check box for each item, its details below it
    const QString field = path.section('.', 2);
    const bool colour = field == "color" || field == "albedo";
    return {colour ? QObject::tr("Colour") : wordsOf(field), field != "shown"};
  }
  if (path.startsWith("light.environment.")) return {environmentLabel(path.section('.', 2)), false};
  if (name == "albedo") return {QObject::tr("Colour"), false};
  if (name == "albedo_source") return {QObject::tr("Colour source"), false};
  if (name.startsWith("albedo_")) return {wordsOf("colour_" + name.mid(7)), true};
  if (path == "gi.sh_order") return {QObject::tr("SH order"), false};
  if (path == "gi.sh_window") return {QObject::tr("SH window"), false};
  if (path == "look.curvature_points") return {QObject::tr("Colours of κ₁ and κ₂"), false};
  QString words = plainWordsOf(name);
  words.replace("color", "colour").replace("Color", "Colour");
  if (words == "Colourmap") words = "Colour map";
  return {translated(texts::words, words.toStdString()), false};
}

QString titleOf(const scene::SceneList& list, const scene::Scene& scene, const std::string& id) {
  const std::string path = list.path + '.' + id;
  const std::string name = scene::setting(path + ".name").get(scene).get<std::string>();
  if (!name.empty()) return QString::fromStdString(name);
  const auto number = scene::positionOf(scene, path).value_or(0) + 1;
  return list.path == "lamps" ? QObject::tr("Light %1").arg(number)
                              : QObject::tr("Isosurface %1").arg(number);
}

}  // namespace isolux::ui
