// Creates settings from members, for the lists of scene/settings/settings.cpp and
// scene/settings/host_settings.cpp.
#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "scene/settings/choice_names.h"
#include "scene/settings/setting_value.h"

namespace isolux::scene {

template <class T>
inline constexpr bool kIsOptional = false;
template <class T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

// Returns the type of a setting stored in a T or an optional T.
template <class T>
constexpr SettingType typeOf() {
  if constexpr (kIsOptional<T>) return typeOf<typename T::value_type>();
  if constexpr (std::is_enum_v<T>) return SettingType::choice;
  if constexpr (std::is_same_v<T, double>) return SettingType::number;
  if constexpr (std::is_same_v<T, int>) return SettingType::integer;
  if constexpr (std::is_same_v<T, bool>) return SettingType::toggle;
  if constexpr (std::is_same_v<T, std::string>) return SettingType::text;
  if constexpr (std::is_same_v<T, glm::dvec2>) return SettingType::pair;
  if constexpr (std::is_same_v<T, glm::dvec3>) return SettingType::vector;
  if constexpr (std::is_same_v<T, glm::dvec4>) return SettingType::quaternion;
  if constexpr (std::is_same_v<T, std::vector<CurvaturePoint>>) return SettingType::points;
  if constexpr (std::is_same_v<T, std::vector<ColorPoint>>) return SettingType::color_points;
  if constexpr (std::is_same_v<T, std::vector<glm::dvec3>>) return SettingType::positions;
  if constexpr (std::is_same_v<T, std::vector<ClipPlane>>) return SettingType::planes;
  if constexpr (std::is_same_v<T, std::vector<Mark>>) return SettingType::marks;
}

struct Range {
  double minimum, maximum;
};
inline constexpr Range positionRange{-1e13, 1e13};  // mm: 4096 voxels of 1e9 mm and a camera for them
inline constexpr Range unitRange{0.0, 1.0};

// Collects the settings of an Owner, in the order in which they are added. `member` returns the member of an
// Owner or const Owner by reference.
template <class Owner>
class SettingList {
 public:
  template <class Member>
  void add(const std::string& path, Member member, Range range, const std::string& unit,
           const std::string& meaning) {
    using T = std::remove_cvref_t<decltype(member(std::declval<const Owner&>()))>;
    SettingInfo info{path, typeOf<T>(), unit, meaning, range.minimum, range.maximum, kIsOptional<T>, {}};
    if constexpr (std::is_enum_v<T>) info.choices.assign(choiceNames<T>().begin(), choiceNames<T>().end());
    list_.push_back({info, [member](const Owner& owner) { return jsonOf(member(owner)); },
                     [member, info](Owner& owner, const nlohmann::json& value) {
                       assignChecked(info, member(owner), value);
                     }});
  }
  // Adds a text, a toggle or a choice.
  template <class Member>
  void add(const std::string& path, Member member, const std::string& meaning) {
    add(path, member, {0.0, 0.0}, "", meaning);
  }
  // Adds a direction: a vector that must not be (nearly) zero.
  template <class Member>
  void addDirection(const std::string& path, Member member, const std::string& meaning) {
    add(path, member, {-1e6, 1e6}, "", meaning);
    const auto holds = [](const std::optional<glm::dvec3>& v) { return !v || !(glm::length(*v) < 1e-6); };
    check(member, holds, "a direction must not be zero");
  }
  // Adds a rotation: a quaternion that must not be (nearly) zero.
  template <class Member>
  void addRotation(const std::string& path, Member member, const std::string& meaning) {
    add(path, member, {-1e6, 1e6}, "quaternion w,x,y,z", meaning);
    const auto holds = [](const glm::dvec4& q) { return !(glm::length(q) < 1e-6); };
    check(member, holds, "a rotation must not be zero");
  }
  // Adds a check to the last setting: values for which holds() is false are rejected with `reason`.
  template <class Member, class Holds>
  void check(Member member, Holds holds, const char* reason) {
    SettingOf<Owner>& setting = list_.back();
    setting.set = [checked = setting.set, member, holds, reason, name = setting.path](
                      Owner& owner, const nlohmann::json& value) {
      Owner trial;
      checked(trial, value);
      if (!holds(member(trial))) refuse(name, reason);
      member(owner) = member(trial);
    };
  }

  std::vector<SettingOf<Owner>> take() { return std::move(list_); }

 private:
  std::vector<SettingOf<Owner>> list_;
};

}  // namespace isolux::scene

// The name of a member cannot be in parentheses in this macro. NOLINTBEGIN(bugprone-macro-parentheses)
#define ISOLUX_MEMBER(name)  \
  [](auto& owner) -> auto& { \
    return owner.name;       \
  }
#define ISOLUX_ITEM(list, index, name) \
  [index](auto& owner) -> auto& {      \
    return owner.list[index].name;     \
  }
// NOLINTEND(bugprone-macro-parentheses)
