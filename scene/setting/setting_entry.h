// Makes settings from members: for the lists of scene/settings.cpp and scene/machine.cpp.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

#include <glm/geometric.hpp>

#include "scene/setting/choice_names.h"
#include "scene/setting/setting_value.h"

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
inline constexpr Range noRange{0.0, 0.0};  // texts and choices
inline constexpr Range positionRange{-1e9, 1e9};
inline constexpr Range unitRange{0.0, 1.0};

// `member` returns the member of an Owner or const Owner by reference.
template <class Owner, class Member>
SettingOf<Owner> entry(std::string path, Member member, Range range, std::string unit, std::string meaning) {
  using T = std::remove_cvref_t<decltype(member(std::declval<const Owner&>()))>;
  SettingOf<Owner> result;
  result.path = std::move(path);
  result.type = TypeOf<T>::type;
  result.unit = std::move(unit);
  result.meaning = std::move(meaning);
  result.minimum = range.minimum;
  result.maximum = range.maximum;
  result.mayBeAutomatic = TypeOf<T>::automatic;
  result.get = [member](const Owner& owner) { return jsonOf(member(owner)); };
  result.set = [member, limits = SettingInfo(result)](Owner& owner, const nlohmann::json& value) {
    assignChecked(limits, member(owner), value);
  };
  return result;
}

// A direction: a vector that must not be (nearly) zero.
template <class Owner, class Member>
SettingOf<Owner> directionEntry(std::string path, Member member, std::string unit, std::string meaning) {
  SettingOf<Owner> result =
      entry<Owner>(std::move(path), member, Range{-1e6, 1e6}, std::move(unit), std::move(meaning));
  result.set = [checked = result.set, member, name = result.path](Owner& owner, const nlohmann::json& value) {
    Owner trial;
    checked(trial, value);
    const std::optional<glm::dvec3> direction = member(trial);
    if (direction && glm::length(*direction) < 1e-6) refuse(name, "a direction must not be zero");
    member(owner) = member(trial);
  };
  return result;
}

// A rotation: a quaternion that must not be (nearly) zero.
template <class Owner, class Member>
SettingOf<Owner> rotationEntry(std::string path, Member member, std::string meaning) {
  SettingOf<Owner> result =
      entry<Owner>(std::move(path), member, Range{-1e6, 1e6}, "quaternion w,x,y,z", std::move(meaning));
  result.set = [checked = result.set, member, name = result.path](Owner& owner, const nlohmann::json& value) {
    Owner trial;
    checked(trial, value);
    if (glm::length(member(trial)) < 1e-6) refuse(name, "a rotation must not be zero");
    member(owner) = member(trial);
  };
  return result;
}

// A range: the first number must not be above the second.
template <class Owner, class Member>
SettingOf<Owner> bandEntry(std::string path, Member member, std::string unit, std::string meaning) {
  SettingOf<Owner> result =
      entry<Owner>(std::move(path), member, Range{-1e38, 1e38}, std::move(unit), std::move(meaning));
  result.set = [checked = result.set, member, name = result.path](Owner& owner, const nlohmann::json& value) {
    Owner trial;
    checked(trial, value);
    const std::optional<glm::dvec2> band = member(trial);
    if (band && band->x > band->y) refuse(name, "the lower end must not be above the upper end");
    member(owner) = member(trial);
  };
  return result;
}

// Of a member whose type is an enumeration of scene/choices.h.
template <class Owner, class Member>
SettingOf<Owner> choiceEntry(std::string path, Member member, std::string meaning) {
  using T = std::remove_cvref_t<decltype(member(std::declval<const Owner&>()))>;
  SettingOf<Owner> result;
  result.path = std::move(path);
  result.type = SettingType::choice;
  result.meaning = std::move(meaning);
  result.minimum = noRange.minimum;
  result.maximum = noRange.maximum;
  for (const Named<T>& choice : choicesOf<T>()) result.choices.emplace_back(choice.name);
  result.get = [member](const Owner& owner) {
    const std::span<const Named<T>> all = choicesOf<T>();
    return nlohmann::json(std::find_if(all.begin(), all.end(), [&](auto& named) {
                            return named.value == member(owner);
                          })->name);
  };
  result.set = [member, limits = SettingInfo(result)](Owner& owner, const nlohmann::json& value) {
    if (!value.is_string()) refuseValue(limits, value);
    const auto& word = value.get_ref<const std::string&>();
    const std::span<const Named<T>> all = choicesOf<T>();
    const auto found = std::find_if(all.begin(), all.end(), [&](auto& named) { return named.name == word; });
    if (found == all.end()) refuseValue(limits, value);
    member(owner) = found->value;
  };
  return result;
}

}  // namespace isolux::scene

// A member's name cannot stand in parentheses.
// NOLINTBEGIN(bugprone-macro-parentheses)
#define ISOLUX_MEMBER(name)  \
  [](auto& owner) -> auto& { \
    return owner.name;       \
  }
#define ISOLUX_ITEM(list, index, name) \
  [index](auto& owner) -> auto& {      \
    return owner.list[index].name;     \
  }
// NOLINTEND(bugprone-macro-parentheses)
