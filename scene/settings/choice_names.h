// Provides the names of enumeration values as used after --set and in sessions.
#pragma once

#include <span>
#include <string_view>

#include "scene/choices.h"

namespace isolux::scene {

template <class T>
struct Named {
  T value;
  std::string_view name;
};

// Returns all values of an enumeration of scene/choices.h or scene/settings/machine.h, in the order in which
// users see them.
template <class T>
std::span<const Named<T>> choicesOf();

template <class T>
std::string_view choiceName(T value) {
  for (const Named<T>& choice : choicesOf<T>())
    if (choice.value == value) return choice.name;
  return {};
}

}  // namespace isolux::scene
