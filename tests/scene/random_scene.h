// Scenes with every setting at random, for tests that go through the list.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "scene/settings/scene_list.h"

namespace isolux::test {

inline double randomIn(double low, double high, std::mt19937_64& random) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

// Gives a setting a random value that it allows.
inline void setRandomly(const scene::Setting& s, scene::Scene& made, std::mt19937_64& random) {
  using scene::SettingType;
  const auto number = [&] { return randomIn(s.minimum, s.maximum, random); };
  switch (s.type) {
    case SettingType::number:
      s.set(made, number());
      break;
    case SettingType::integer:
      s.set(made, std::floor(number()));
      break;
    case SettingType::text:
      s.set(made, "text \"with\" ünïcode \\ " + std::to_string(random() % 1000));
      break;
    case SettingType::choice:
      s.set(made, s.choices[random() % s.choices.size()]);
      break;
    case SettingType::pair: {
      const double a = number(), b = number();
      s.set(made, {std::min(a, b), std::max(a, b)});
      break;
    }
    case SettingType::vector:
      s.set(made, {number(), number(), number()});
      break;
    case SettingType::quaternion:
      s.set(made, {number(), number(), number(), number()});
      break;
    case SettingType::toggle:
      s.set(made, random() % 2 == 0);
      break;
    case SettingType::positions:
      s.set(made, nlohmann::json::array({{number(), number(), number()}, {number(), number(), number()}}));
      break;
    case SettingType::planes:
      s.set(made, nlohmann::json::array({{number(), number(), number(), 1.0, number(), number()}}));
      break;
    case SettingType::marks:
      s.set(made, nlohmann::json::array({{{"kind", "angle"},
                                          {"name", "b"},
                                          {"points", {{number(), number(), number()}}},
                                          {"color", {0.25, 0.5, 1.0}},
                                          {"shown", true}}}));
      break;
    case SettingType::color_points:
      s.set(made, nlohmann::json::array({{0, 0.25, 0.5, 1.0}, {1, 0, 0, std::abs(number())}}));
      break;
    case SettingType::points:
      s.set(made,
            nlohmann::json::array({{number(), number(), 0.25, 0.5, 1.0}, {-1, 1, 0, 0, std::abs(number())}}));
      break;
    case SettingType::item:
    case SettingType::ids:
      break;
  }
  if (s.mayBeAutomatic && random() % 4 == 0) s.set(made, "auto");
}

// The settings of every scene, and those of the items that this one has.
inline std::vector<scene::Setting> everySetting(const scene::Scene& scene) {
  std::vector<scene::Setting> all(scene::settings().begin(), scene::settings().end());
  for (scene::Setting& ofItem : scene::itemSettings(scene)) all.push_back(std::move(ofItem));
  return all;
}

// A scene with every setting at random, and any number of items in its lists.
inline scene::Scene randomScene(std::mt19937_64& random) {
  scene::Scene made;
  for (const scene::Setting& s : scene::settings()) setRandomly(s, made, random);
  for (const scene::SceneList& list : scene::sceneLists()) {
    std::vector<std::string> ids{"key", "fill", "window_2"};
    std::ranges::shuffle(ids, random);
    ids.resize(std::max(list.least, random() % (ids.size() + 1)));
    list.arrange(made, ids);
  }
  for (const scene::Setting& s : scene::itemSettings(made)) setRandomly(s, made, random);
  return made;
}

}  // namespace isolux::test
