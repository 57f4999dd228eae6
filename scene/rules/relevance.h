// Which settings act in a scene, and why the others do not.
//
// One table of rules, from a setting's path to a condition on the scene. The window hides what does not act,
// and anything else that explains a scene can say the same.
#pragma once

#include <string_view>
#include <vector>

#include "scene/rules/needs.h"
#include "scene/scene.h"

namespace isolux::scene {

// Empty when the setting of this path acts, that is, when changing it can change the picture, the memory or
// the time it takes; else one clause that says why not: "hits are exact". `scene` may have automatic members.
std::string_view whyInactive(std::string_view path, const Scene& scene);
// All that it can answer, for who translates.
std::vector<std::string_view> inactiveReasons();

}  // namespace isolux::scene
