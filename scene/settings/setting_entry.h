// Creates settings from members, for the lists of scene/settings/settings.cpp and scene/settings/machine.cpp.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

#include <glm/geometric.hpp>

#include "scene/settings/choice_names.h"
#include "scene/settings/setting_value.h"

namespace isolux::scene {

template <class T>
struct TypeOf;
template <>
struct TypeOf<double> {
  static constexpr SettingType type = SettingType::number;
  static constexpr bool automatic = false;
};
template <>
struct TypeOf<int> {
  static constexpr SettingType type = SettingType::integer;
  static constexpr bool automatic = false;
};
template <>
struct TypeOf<bool> {
  static constexpr SettingType type = SettingType::toggle;
  static constexpr bool automatic = false;
};
template <>
struct TypeOf<std::vector<CurvaturePoint>> {
  static constexpr SettingType type = SettingType::points;
  static constexpr bool automatic = false;
};
template <>
struct TypeOf<std::vector<ColorPoint>> {
  static constexpr SettingType type = SettingType::color_points;
  static constexpr bool automatic = false;
};
template <>
struct TypeOf<std::vector<glm::dvec3>> {
  static constexpr SettingType type = SettingType::positions;
  static constexpr bool automatic = false;
};
template <>
struct TypeOf<std::vector<ClipPlane>> {
  static constexpr SettingType type = SettingType::planes;
  static constexpr bool automatic = false;
};
template <>
struct TypeOf<std::vector<Mark>> {
  static constexpr SettingType type = SettingType::marks;
  static constexpr bool automatic = false;
};
template <>
struct TypeOf<std::string> {
  static constexpr SettingType type = SettingType::text;
  static constexpr bool automatic = false;
};
template <int N>
struct TypeOf<glm::vec<N, double>> {
  static constexpr SettingType type = N == 2   ? SettingType::pair
                                      : N == 3 ? SettingType::vector
                                               : SettingType::quaternion;
  static constexpr bool automatic = false;
};
template <class T>
struct TypeOf<std::optional<T>> {
  static constexpr SettingType type = TypeOf<T>::type;
  static constexpr bool automatic = true;
};

struct Range {
  double minimum, maximum;
};
inline constexpr Range noRange{0.0, 0.0};           // texts and choices
inline constexpr Range positionRange{-1e13, 1e13};  // mm: 4096 voxels of 1e9 mm and a camera for them
inline constexpr Range unitRange{0.0, 1.0};

// Creates a setting. `member` returns the member of an Owner or const Owner by reference.
template <class Owner, class Member>
SettingOf<Owner> entry(const std::string& path, Member member, Range range, const std::string& unit,
                       const std::string& meaning) {
  using T = std::remove_cvref_t<decltype(member(std::declval<const Owner&>()))>;
  const SettingInfo info{path,          TypeOf<T>::type,      unit, meaning, range.minimum,
                         range.maximum, TypeOf<T>::automatic, {}};
  return {info, [member](const Owner& owner) { return jsonOf(member(owner)); },
          [member, info](Owner& owner, const nlohmann::json& value) {
            assignChecked(info, member(owner), value);
          }};
}

// Adds a check to a setting: values for which holds() is false are rejected with `reason`.
template <class Owner, class Member, class Holds>
SettingOf<Owner> onlyWhere(SettingOf<Owner> setting, Member member, Holds holds, const char* reason) {
  setting.set = [checked = setting.set, member, holds, reason, name = setting.path](
                    Owner& owner, const nlohmann::json& value) {
    Owner trial;
    checked(trial, value);
    if (!holds(member(trial))) refuse(name, reason);
    member(owner) = member(trial);
  };
  return setting;
}

// Creates a direction: a vector that must not be (nearly) zero.
template <class Owner, class Member>
SettingOf<Owner> directionEntry(const std::string& path, Member member, const std::string& unit,
                                const std::string& meaning) {
  const auto holds = [](const std::optional<glm::dvec3>& v) { return !v || !(glm::length(*v) < 1e-6); };
  return onlyWhere<Owner>(entry<Owner>(path, member, Range{-1e6, 1e6}, unit, meaning), member, holds,
                          "a direction must not be zero");
}

// Creates a rotation: a quaternion that must not be (nearly) zero.
template <class Owner, class Member>
SettingOf<Owner> rotationEntry(const std::string& path, Member member, const std::string& meaning) {
  const auto holds = [](const glm::dvec4& q) { return !(glm::length(q) < 1e-6); };
  return onlyWhere<Owner>(entry<Owner>(path, member, Range{-1e6, 1e6}, "quaternion w,x,y,z", meaning), member,
                          holds, "a rotation must not be zero");
}

// Creates a range: the first number must not be above the second.
template <class Owner, class Member>
SettingOf<Owner> bandEntry(const std::string& path, Member member, const std::string& unit,
                           const std::string& meaning) {
  const auto holds = [](const std::optional<glm::dvec2>& band) { return !band || !(band->x > band->y); };
  return onlyWhere<Owner>(entry<Owner>(path, member, Range{-1e38, 1e38}, unit, meaning), member, holds,
                          "the lower end must not be above the upper end");
}

// Creates a choice from a member whose type is an enumeration of scene/choices.h.
template <class Owner, class Member>
SettingOf<Owner> choiceEntry(const std::string& path, Member member, const std::string& meaning) {
  using T = std::remove_cvref_t<decltype(member(std::declval<const Owner&>()))>;
  SettingInfo info{path, SettingType::choice, "", meaning, noRange.minimum, noRange.maximum, false, {}};
  for (const Named<T>& choice : choicesOf<T>()) info.choices.emplace_back(choice.name);
  const auto get = [member](const Owner& owner) {
    const std::span<const Named<T>> all = choicesOf<T>();
    const auto same = [&](const Named<T>& named) { return named.value == member(owner); };
    return nlohmann::json(std::find_if(all.begin(), all.end(), same)->name);
  };
  const auto set = [member, info](Owner& owner, const nlohmann::json& value) {
    if (!value.is_string()) refuseValue(info, value);
    const auto& word = value.get_ref<const std::string&>();
    const std::span<const Named<T>> all = choicesOf<T>();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Named<T>& named) { return named.name == word; });
    if (found == all.end()) refuseValue(info, value);
    member(owner) = found->value;
  };
  return {info, get, set};
}

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
