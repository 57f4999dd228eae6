// Determines which settings are active in a scene, and why others are not.
//
// One table of rules maps a setting's path to a condition on the scene. The window hides inactive settings;
// other explanations of a scene use the same text.
#pragma once

#include <string_view>
#include <vector>

#include "scene/rules/needs.h"
#include "scene/scene.h"

namespace isolux::scene {

// Returns "" if the setting of this path is active: changing it can change the image, the memory or the time.
// Otherwise returns one clause with the reason: "hits are exact". `scene` may have automatic members.
std::string_view whyInactive(std::string_view path, const Scene& scene);
// Returns all possible reasons, for translation.
std::vector<std::string_view> inactiveReasons();

}  // namespace isolux::scene
