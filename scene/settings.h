// The list of settings: each member of Scene once, with path, type, default, range, unit and meaning.
//
// JSON, --set, undo, recordings, hashing, `isolux settings` and the documentation are made from this list.
// Paths are "group.name" or "group.subgroup.name" in snake_case. Errors are base::Error of kind usage that
// name the path.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "scene/scene.h"

namespace isolux::scene {

// pair, vector, quaternion: two, three, four numbers; points: a list of CurvaturePoint, each [kappa1, kappa2,
// r, g, b]
enum class SettingType { number, integer, text, choice, pair, vector, quaternion, toggle, points };
// Numbers in a pair, vector or quaternion; 0 for other types.
std::size_t componentsOf(SettingType type);

struct Setting {
  std::string path;
  SettingType type;
  std::string unit;                                 // "mm", "degrees", "data units", "" where none
  std::string meaning;                              // one sentence
  double minimum, maximum;                          // of numbers, integers and vector components, inclusive
  bool mayBeAutomatic = false;                      // accepts "auto" (an empty optional)
  std::vector<std::string> choices;                 // of a choice
  std::function<nlohmann::json(const Scene&)> get;  // "auto" for an empty optional
  std::function<void(Scene&, const nlohmann::json&)> set;  // throws Error when type, range or choice is wrong

  nlohmann::json defaultValue() const { return get(Scene{}); }
};

std::span<const Setting> settings();
const Setting& setting(std::string_view path);  // throws Error, with the nearest path as a suggestion

// "a.b=VALUE" as on the command line: numbers, "x,y,z", words; VALUE may be "auto" where allowed.
void applyAssignment(Scene& scene, std::string_view assignment);

// Whole scenes as nested JSON objects. A missing key takes its default; an unknown key throws, naming its
// path.
nlohmann::json toJson(const Scene& scene);
Scene fromJson(const nlohmann::json& json);

// A named change: undo, redo, recordings and --set are all made of these.
struct SceneChange {
  std::string path;
  nlohmann::json value;
  bool operator==(const SceneChange&) const = default;
};
struct SceneDiff {
  std::string name;  // what the user did: "Rotate", "Set isovalue"
  std::vector<SceneChange> changes;
  bool operator==(const SceneDiff&) const = default;
};
SceneDiff difference(const Scene& from, const Scene& to, std::string name);
Scene applied(Scene scene, const SceneDiff& diff);

// A name for the change from one scene to another, made from the settings that differ ("Change look.mode").
std::string describeChange(const Scene& from, const Scene& to);

}  // namespace isolux::scene
