// Converts values of settings to and from JSON and checks them against the setting's description. Errors are
// base::Error of kind usage that name the path.
#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <nlohmann/json.hpp>

#include "scene/scene.h"
#include "scene/settings/choice_names.h"
#include "scene/settings/setting.h"

namespace isolux::scene {

// Throws base::Error{usage} that names `path` and `reason`.
[[noreturn]] void refuse(const std::string& path, const std::string& reason);
// Throws "VALUE is not allowed here; allowed is ...".
[[noreturn]] void refuseValue(const SettingInfo& setting, const nlohmann::json& value);

// Returns a finite number in the setting's range. Throws otherwise, showing `whole`.
double checkedNumber(const SettingInfo& setting, const nlohmann::json& value, const nlohmann::json& whole);

void assignChecked(const SettingInfo& setting, double& member, const nlohmann::json& value);
void assignChecked(const SettingInfo& setting, int& member, const nlohmann::json& value);
void assignChecked(const SettingInfo& setting, bool& member, const nlohmann::json& value);
void assignChecked(const SettingInfo& setting, std::string& member, const nlohmann::json& value);
void assignChecked(const SettingInfo& setting, std::vector<CurvaturePoint>& member,
                   const nlohmann::json& value);
void assignChecked(const SettingInfo& setting, std::vector<ColorPoint>& member, const nlohmann::json& value);
void assignChecked(const SettingInfo& setting, std::vector<glm::dvec3>& member, const nlohmann::json& value);
void assignChecked(const SettingInfo& setting, std::vector<ClipPlane>& member, const nlohmann::json& value);
void assignChecked(const SettingInfo& setting, std::vector<Mark>& member, const nlohmann::json& value);

template <class T>
requires std::is_enum_v<T>
void assignChecked(const SettingInfo& setting, T& member, const nlohmann::json& value) {
  if (!value.is_string()) refuseValue(setting, value);
  const std::optional<T> named = choiceNamed<T>(value.get_ref<const std::string&>());
  if (!named) refuseValue(setting, value);
  member = *named;
}

template <int N>
void assignChecked(const SettingInfo& setting, glm::vec<N, double>& member, const nlohmann::json& value) {
  if (!value.is_array() || value.size() != N) refuseValue(setting, value);
  glm::vec<N, double> vector;
  for (int i = 0; i < N; ++i) vector[i] = checkedNumber(setting, value[static_cast<std::size_t>(i)], value);
  member = vector;
}

template <class T>
void assignChecked(const SettingInfo& setting, std::optional<T>& member, const nlohmann::json& value) {
  if (value.is_string() && value.get_ref<const std::string&>() == "auto") {
    member.reset();
    return;
  }
  T plain{};
  assignChecked(setting, plain, value);
  member = plain;
}

// Returns the JSON of a number, a text, a toggle or a choice.
template <class T>
nlohmann::json jsonOf(const T& value) {
  if constexpr (std::is_enum_v<T>)
    return choiceName(value);
  else
    return value;
}
nlohmann::json jsonOf(const std::vector<CurvaturePoint>& points);
nlohmann::json jsonOf(const std::vector<ColorPoint>& points);
nlohmann::json jsonOf(const std::vector<glm::dvec3>& positions);
nlohmann::json jsonOf(const std::vector<ClipPlane>& planes);
nlohmann::json jsonOf(const std::vector<Mark>& marks);

template <int N>
nlohmann::json jsonOf(const glm::vec<N, double>& value) {
  nlohmann::json list = nlohmann::json::array();
  for (int i = 0; i < N; ++i) list.push_back(value[i]);
  return list;
}

template <class T>
nlohmann::json jsonOf(const std::optional<T>& value) {
  return value ? jsonOf(*value) : nlohmann::json("auto");
}

}  // namespace isolux::scene
