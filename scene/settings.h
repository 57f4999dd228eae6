// The list of settings: each member of Scene once, with path, type, default, range, unit and meaning.
//
// JSON, --set, undo, recordings, hashing, `isolux settings` and the documentation are made from this list.
// Paths are "group.name" or "group.subgroup.name" in snake_case. Errors are base::Error of kind usage that
// name the path.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"
#include "scene/setting/setting.h"

namespace isolux::scene {

using Setting = SettingOf<Scene>;

std::span<const Setting> settings();
// Whether a pattern stands for a path: "camera." for all of a group, '#' for the number of an item of a list
// ("lamp#.kind"), else the path itself.
bool covers(std::string_view pattern, std::string_view path);
const Setting& setting(std::string_view path);  // throws Error, with the nearest path as a suggestion

// As on the command line: scene/setting/assignment.h.
void applyAssignment(Scene& scene, std::string_view assignment);

// Whole scenes as nested JSON objects. A missing key takes its default; an unknown key throws, naming its
// path. Settings of the machine (scene/machine.h), which older files have, are passed over.
nlohmann::json toJson(const Scene& scene);
Scene fromJson(const nlohmann::json& json);

// A name for the change from one scene to another, made from the settings that differ ("Change look.mode").
std::string describeChange(const Scene& from, const Scene& to);

}  // namespace isolux::scene
