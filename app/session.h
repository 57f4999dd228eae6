// Sessions: a Scene as versioned JSON, in a .isolux file or inside a PNG or EXR picture.
//
// {"isolux_session": 2, "program": "0.1.0", "scene": {...}}. An unknown key fails with its path, an older
// version is upgraded, a missing key takes its default. source.path is stored relative to the session file
// when it lies below the same folder, and is absolute in memory.
#pragma once

#include <filesystem>
#include <string>

#include "scene/scene.h"

namespace isolux::app {

constexpr int sessionVersion = 2;

std::string sessionText(const scene::Scene& scene, const std::filesystem::path& folder);
// `file` is for error messages. Throws scene::Error{input} with the JSON path or byte of the fault.
scene::Scene parseSession(const std::string& text, const std::string& file,
                          const std::filesystem::path& folder);

void saveSession(const scene::Scene& scene, const std::filesystem::path& file);  // beside, then renamed
scene::Scene loadSession(const std::filesystem::path& file);  // .isolux, .json, .png or .exr

// True for files that loadSession() should be tried on (by content).
bool isSession(const std::filesystem::path& file);

}  // namespace isolux::app
