// Lists the settings: each member of Scene once, with path, type, default, range, unit and meaning. Settings
// of items of lists have paths "list.id.name": scene/settings/scene_list.h.
//
// JSON, --set, undo, recordings, hashing, `isolux settings` and the documentation are generated from this
// list. Paths are "group.name" or "group.subgroup.name" in snake_case. Errors are base::Error of kind usage
// that name the path.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"
#include "scene/settings/setting.h"

namespace isolux::scene {

using Setting = SettingOf<Scene>;

std::span<const Setting> settings();  // without those of items
// Returns whether a pattern covers a path: "camera." all paths of a group, '#' any id or number
// ("lamps.#.kind"), otherwise the path itself.
bool covers(std::string_view pattern, std::string_view path);
// Returns the setting of a path, also of an item, of a whole item and of the order of a list. Throws Error,
// with the nearest path as a suggestion.
Setting setting(std::string_view path);

// Applies an assignment as on the command line: scene/settings/assignment.h.
void applyAssignment(Scene& scene, std::string_view assignment);

// Convert whole scenes to and from nested JSON objects. A missing key takes its default; an unknown key
// throws, naming its path. Host settings (scene/settings/host_settings.h), which older files contain, are
// ignored.
nlohmann::json toJson(const Scene& scene);
Scene fromJson(const nlohmann::json& json);

}  // namespace isolux::scene
