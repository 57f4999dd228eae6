// Scenes as they stand in sessions and recordings: JSON, with source.path and source.csg_path relative to the
// file's folder when the volume lies below it, so that a folder can be moved or given away as a whole.
//
// Errors: scene::Error{input} with the file and the JSON path.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "scene/settings.h"

namespace isolux::app {

// The settings that name files: volumes and light probes.
bool isStoredPath(std::string_view setting);
// "phantom:..." and "" stay as they are. `folder` empty: the current one.
std::string storedSourcePath(const std::string& path, const std::filesystem::path& folder);
std::string sourcePathFromStored(const std::string& stored, const std::filesystem::path& folder);

nlohmann::json storedScene(const scene::Scene& scene, const std::filesystem::path& folder);
// `place` stands before each JSON path in messages ("scene").
scene::Scene sceneFromStored(const nlohmann::json& stored, const std::string& file, const std::string& place,
                             const std::filesystem::path& folder);

// `stored` must be an object with no other keys than the `known` ones; `place` as above.
void checkKeys(const nlohmann::json& stored, std::initializer_list<std::string_view> known,
               const std::string& file, const std::string& place);

// Parses with the byte of a fault in the message; `place` stands before it ("line 3").
nlohmann::json parseJson(const std::string& text, const std::string& file, const std::string& place);

}  // namespace isolux::app
