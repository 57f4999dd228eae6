#include "app/presets/preset.h"

#include <algorithm>
#include <array>

#include "app/documents/stored_scene.h"
#include "app/files/json_text.h"
#include "app/presets/preset_list.h"
#include "app/presets/preset_value.h"
#include "base/error.h"
#include "scene/settings/host_settings.h"
#include "scene/settings/scene_diff.h"
#include "scene/settings/scene_list.h"
#include "scene/settings/settings.h"

namespace isolux::app {

namespace {

using nlohmann::ordered_json;

struct NeedInfo {
  PresetNeed need;
  const char* name;
  const char* reason;  // why a volume without it is refused
};
constexpr std::array<NeedInfo, 8> kNeeds{
    NeedInfo{PresetNeed::hounsfield, "hounsfield", "it is no CT, or its values do not tell Hounsfield units"},
    {PresetNeed::not_hounsfield, "not_hounsfield", "it is a CT"},
    {PresetNeed::patient, "patient", "it is no scan of a patient"},
    {PresetNeed::no_patient, "no_patient", "it is a scan of a patient"},
    {PresetNeed::distance, "distance", "its values are not distances in mm"},
    {PresetNeed::microscopy, "microscopy", "it is known to be of another kind than microscopy"},
    {PresetNeed::simulation, "simulation", "it is known to be of another kind than a simulation"},
    {PresetNeed::white_matter, "white_matter", "no white matter of a T1 scan is found in it"}};

constexpr std::array<const char*, 13> kOfVolume{
    "source.",        "camera.eye",  "camera.target", "camera.up",         "pieces.hidden",
    "pieces.only",    "clip.planes", "clip.box",      "clip.box_rotation", "clip.removed",
    "slice.position", "marks.",      "color."};
constexpr std::array<const char*, 9> kReset{"isosurface.",     "surfaces.",     "look.",
                                            "flow.",           "pieces.keep",   "pieces.depth",
                                            "pieces.smallest", "pieces.within", "light.environment.builtin"};

bool coveredByOne(std::span<const char* const> patterns, const std::string& path) {
  return std::ranges::any_of(patterns, [&](const char* pattern) { return scene::covers(pattern, path); });
}

std::string textAt(const ordered_json& json, const char* key, const std::filesystem::path& file) {
  if (!json.contains(key) || !json[key].is_string() || json[key].get<std::string>().empty())
    base::throwInput(file, key, "must be a text");
  return json[key].get<std::string>();
}

PresetNeed needNamed(const ordered_json& name, const std::filesystem::path& file) {
  for (const NeedInfo& info : kNeeds)
    if (name == info.name) return info.need;
  base::throwInput(file, "needs", name.dump() + " is no need of a preset");
}

bool isIsovalue(const std::string& path) {
  return scene::patternOf(path) == "surfaces.#.value";
}

// Refuses what withPreset() could not apply. `trial`: the scene after the settings before.
void checkPresetSetting(const std::string& path, const ordered_json& value, const std::filesystem::path& file,
                        scene::Scene& trial) {
  if (belongsToVolume(path))
    base::throwInput(file, path, "belongs to one volume or machine; no preset sets it");
  try {
    const scene::Setting setting = scene::setting(path);
    if (isValueOfVolume(value)) checkValueOfVolume(setting, value);
    setting.set(trial, isValueOfVolume(value) ? nlohmann::json(0.0) : nlohmann::json(value));
  } catch (const base::Error& error) {
    base::throwInput(file, path, error.reason());
  }
}

void checkPresetName(const std::string& name, const std::filesystem::path& file) {
  const bool plain = std::ranges::all_of(name, [](unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-' || c >= 128;
  });
  if (!plain)
    base::throwInput(file, "name",
                     "may have lower case letters, letters beyond ASCII, digits, '_' and '-' only");
}

// What a scene has other than a new one, items of lists by their position, as before there were lists.
std::vector<scene::SceneChange> settingsOf(const scene::Scene& scene) {
  std::vector<scene::SceneChange> changes;
  for (const scene::Setting& setting : scene::settings())
    if (nlohmann::json value = setting.get(scene); value != setting.defaultValue())
      changes.push_back({setting.path, std::move(value)});
  for (const scene::SceneList& list : scene::sceneLists()) {
    const std::vector<std::string> ids = list.ids(scene);
    for (std::size_t position = 0; position < ids.size(); ++position) {
      const bool first = position == 0 && list.firstHadNoNumber;
      const std::string group = list.former + (first ? "" : std::to_string(position + 1)) + '.';
      for (std::size_t field = 0; field < list.fields.size(); ++field) {
        nlohmann::json value = list.get(scene, ids[position], field);
        if (value != list.formerValue(position, field))
          changes.push_back({group + std::string(nameOfField(list, list.fields[field])), std::move(value)});
      }
    }
  }
  return changes;
}

// The background is the user's, unless a preset of the program made it what it is.
bool isUsersBackground(const scene::Setting& setting, const scene::Scene& scene) {
  if (!setting.path.starts_with("look.background")) return false;
  const nlohmann::json shown = setting.get(scene);
  const std::span<const Preset> presets = builtInPresets();
  return std::ranges::none_of(presets, [&](const Preset& preset) {
    return preset.settings.contains(setting.path) &&
           nlohmann::json(preset.settings.at(setting.path)) == shown;
  });
}

}  // namespace

bool belongsToVolume(const std::string& path) {
  return scene::patternOf(path) == "lamps.#.position" || coveredByOne(kOfVolume, path) ||
         isStoredPath(path) || scene::isHostSetting(path);
}

bool resetByPreset(const std::string& path) {
  return coveredByOne(kReset, scene::patternOf(path));
}

Preset parsePreset(const std::string& text, const std::filesystem::path& file) {
  const ordered_json json = ordered_json::parse(text, nullptr, false);
  if (json.is_discarded() || !json.is_object() || !json.contains("isolux_preset"))
    base::throwInput(file, "", "is no preset");
  parseJson(text, file.string(), "");  // refuses equal keys
  if (json["isolux_preset"] != kPresetVersion)
    base::throwInput(file, "isolux_preset", "is of another version of Isolux");
  for (const auto& [key, value] : json.items()) {
    constexpr std::array<const char*, 6> known{"isolux_preset", "name", "title", "meaning", "needs", "set"};
    if (std::ranges::none_of(known, [&given = key](const char* k) { return given == k; }))
      base::throwInput(file, key, "is unknown");
  }
  Preset preset;
  preset.file = file;
  preset.name = textAt(json, "name", file);
  checkPresetName(preset.name, file);
  preset.title = textAt(json, "title", file);
  preset.meaning = textAt(json, "meaning", file);
  if (json.contains("needs")) {
    if (!json["needs"].is_array()) base::throwInput(file, "needs", "must be a list");
    for (const ordered_json& need : json["needs"]) preset.needs.push_back(needNamed(need, file));
  }
  if (!json.contains("set") || !json["set"].is_object()) base::throwInput(file, "set", "must be an object");
  scene::Scene trial;
  for (const auto& [path, value] : json["set"].items()) checkPresetSetting(path, value, file, trial);
  preset.settings = json["set"];
  return preset;
}

std::string presetText(const Preset& preset) {
  ordered_json needs = ordered_json::array();
  for (const PresetNeed need : preset.needs)
    for (const NeedInfo& info : kNeeds)
      if (info.need == need) needs.push_back(info.name);
  return jsonText({{"isolux_preset", kPresetVersion},
                   {"name", preset.name},
                   {"title", preset.title},
                   {"meaning", preset.meaning},
                   {"needs", needs},
                   {"set", preset.settings}});
}

std::vector<std::string> needReasons() {
  std::vector<std::string> list;
  list.reserve(kNeeds.size());
  for (const NeedInfo& info : kNeeds) list.emplace_back(info.reason);
  return list;
}

std::string whyNot(const Preset& preset, const volume::PreparedVolume& volume, bool isovalueGiven) {
  using Kind = scene::DataKind;
  const Kind kind = volume.kind.kind;
  const bool ct = kind == Kind::ct_hu || kind == Kind::ct, unknown = kind == Kind::other;
  const bool patient = ct || kind == Kind::mr || volume.facts.axes == scene::WorldAxes::anatomical;
  const auto met = [&](PresetNeed need) {
    switch (need) {
      case PresetNeed::hounsfield:
        return isovalueGiven || volume.kind.hounsfield.has_value();
      case PresetNeed::not_hounsfield:
        return !ct;
      case PresetNeed::patient:
        return patient;
      case PresetNeed::no_patient:
        return !patient;
      case PresetNeed::distance:
        return kind == Kind::distance;
      case PresetNeed::microscopy:
        return unknown || kind == Kind::microscopy;
      case PresetNeed::simulation:
        return unknown || kind == Kind::simulation;
      case PresetNeed::white_matter:
        return isovalueGiven || volume.whiteMatter->get().has_value();
    }
    return false;
  };
  for (const NeedInfo& info : kNeeds)
    if (std::ranges::count(preset.needs, info.need) > 0 && !met(info.need)) return info.reason;
  return {};
}

scene::Scene withPreset(const scene::Scene& scene, const Preset& preset, const volume::PreparedVolume& volume,
                        double shift) {
  scene::Scene result = scene;
  for (const scene::Setting& setting : scene::settings())
    if (resetByPreset(setting.path) && !isUsersBackground(setting, scene))
      setting.set(result, setting.defaultValue());
  result.surfaces = scene::Scene{}.surfaces;
  for (const auto& [path, value] : preset.settings.items()) {
    const scene::Setting setting = scene::setting(path);
    if (isValueOfVolume(value))
      setting.set(result, valueInVolume(value, volume) + (isIsovalue(path) ? shift : 0.0));
    else if (isIsovalue(path) && value.is_number())
      setting.set(result, value.get<double>() + shift);
    else
      setting.set(result, value);
  }
  if (shift != 0.0 && !result.surfaces.front().value)
    result.surfaces.front().value = volume.facts.suggestedIsovalue + shift;
  return result;
}

Preset presetOf(const scene::Scene& scene, const std::string& name, const std::string& title,
                const volume::PreparedVolume* volume) {
  Preset preset{name, title, "A preset of one's own", {}};
  const bool hounsfield = volume != nullptr && volume->kind.kind == scene::DataKind::ct_hu;
  for (const auto& [path, value] : settingsOf(scene)) {
    if (belongsToVolume(path)) continue;
    if (hounsfield && isIsovalue(path) && value.is_number()) {
      preset.settings[path] = {{"hu", value}};
      preset.needs = {PresetNeed::hounsfield};
    } else {
      preset.settings[path] = value;
    }
  }
  return preset;
}

}  // namespace isolux::app
