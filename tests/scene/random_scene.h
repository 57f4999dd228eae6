// Scenes with every setting at random, for tests that go through the list.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "scene/settings/settings.h"

namespace isolux::test {

inline double randomIn(double low, double high, std::mt19937_64& random) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

// A scene with every setting at random.
inline scene::Scene randomScene(std::mt19937_64& random) {
  using scene::SettingType;
  scene::Scene made;
  for (const scene::Setting& s : scene::settings()) {
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
        s.set(made, nlohmann::json::array(
                        {{number(), number(), 0.25, 0.5, 1.0}, {-1, 1, 0, 0, std::abs(number())}}));
        break;
    }
    if (s.mayBeAutomatic && random() % 4 == 0) s.set(made, "auto");
  }
  return made;
}

}  // namespace isolux::test
