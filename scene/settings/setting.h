// Describes a setting: path, type, range, unit and meaning, and how to read and write it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace isolux::scene {

// Types of settings.
//   pair, vector, quaternion   two, three, four numbers
//   points      a list of CurvaturePoint, each [kappa1, kappa2, r, g, b]
//   color_points   a list of ColorPoint in ascending order, each [position, r, g, b]
//   positions   a list of any length of world points [x, y, z]
//   planes      a list of ClipPlane, each [px, py, pz, nx, ny, nz]
//   marks       a list of Mark, each an object
//   item        an item of a list of the scene (scene_list.h): an object of its settings, or null for none
//   ids         the ids of the items of such a list, in their order
enum class SettingType {
  number,
  integer,
  text,
  choice,
  pair,
  vector,
  quaternion,
  toggle,
  points,
  color_points,
  positions,
  planes,
  marks,
  item,
  ids
};
// Returns the number of components of a pair, vector or quaternion; 0 for other types.
std::size_t componentsOf(SettingType type);

struct SettingInfo {
  std::string path;
  SettingType type = SettingType::number;
  std::string unit;                     // "mm", "degrees", "data units", or ""
  std::string meaning;                  // one sentence
  double minimum = 0.0, maximum = 0.0;  // of numbers, integers and vector components, inclusive
  bool mayBeAutomatic = false;          // accepts "auto" (an empty optional)
  std::vector<std::string> choices;     // of a choice
};

// A setting stored in a member of an Owner: a Scene or a HostSettings.
template <class Owner>
struct SettingOf : SettingInfo {
  std::function<nlohmann::json(const Owner&)> get;         // "auto" for an empty optional
  std::function<void(Owner&, const nlohmann::json&)> set;  // throws Error for a wrong type, range or choice

  auto defaultValue() const { return get(Owner{}); }
};

}  // namespace isolux::scene
