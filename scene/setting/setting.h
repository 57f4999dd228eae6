// What is known of one setting: path, type, range, unit and meaning, and how to read and write it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace isolux::scene {

// pair, vector, quaternion: two, three, four numbers; points: a list of CurvaturePoint, each [kappa1, kappa2,
// r, g, b]; positions: a list of any length of world points [x, y, z]; planes: a list of ClipPlane, each [px,
// py, pz, nx, ny, nz]; marks: a list of Mark, each an object
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
  positions,
  planes,
  marks
};
// Numbers in a pair, vector or quaternion; 0 for other types.
std::size_t componentsOf(SettingType type);

struct SettingInfo {
  std::string path;
  SettingType type = SettingType::number;
  std::string unit;                     // "mm", "degrees", "data units", "" where none
  std::string meaning;                  // one sentence
  double minimum = 0.0, maximum = 0.0;  // of numbers, integers and vector components, inclusive
  bool mayBeAutomatic = false;          // accepts "auto" (an empty optional)
  std::vector<std::string> choices;     // of a choice
};

// A member of an Owner: of a Scene, or of a Machine.
template <class Owner>
struct SettingOf : SettingInfo {
  std::function<nlohmann::json(const Owner&)> get;         // "auto" for an empty optional
  std::function<void(Owner&, const nlohmann::json&)> set;  // throws Error when type, range or choice is wrong

  auto defaultValue() const { return get(Owner{}); }
};

}  // namespace isolux::scene
