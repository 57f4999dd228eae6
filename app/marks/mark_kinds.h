// The kinds of marks: their names and how many points each needs.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "scene/scene.h"

namespace isolux::app {

struct MarkKindInfo {
  scene::MarkKind kind;
  const char* name;   // in settings, files and on the command line
  const char* title;  // what a new one is called, a number behind it
  std::size_t fewest, most;
  const char* points;  // "two points or more"
};

std::span<const MarkKindInfo> markKinds();
const MarkKindInfo& markKind(scene::MarkKind kind);

// Empty where the mark has as many points as its kind needs; else a sentence fragment: "an angle needs ...".
std::string wrongPoints(const scene::Mark& mark);

// The first "Distance 3" that none of the marks is called; `title` is the word before the number.
std::string freshName(const std::string& title, std::span<const scene::Mark> marks);
std::string freshName(scene::MarkKind kind, std::span<const scene::Mark> marks);

}  // namespace isolux::app
