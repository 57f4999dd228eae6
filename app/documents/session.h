// Reads and writes sessions: a Scene as versioned JSON, in a .isolux file or inside a PNG or EXR image.
//
// {"isolux_session": 9, "program": "0.2.0", "scene": {...}}. An unknown key fails with its path, an older
// version is upgraded, a missing key takes its default. Paths of volumes and environment maps are stored
// relative to the session file if they are below the same folder, and are absolute in memory.
#pragma once

#include <filesystem>
#include <string>

#include "app/documents/stored_scene.h"
#include "scene/scene.h"

namespace isolux::app {

constexpr int sessionVersion = 10;

std::string sessionText(const scene::Scene& scene, const std::filesystem::path& folder);
// Returns the session for an image in `folder` that may be shared: it names no other folder
// (app/documents/places.h) and not the patient (app/documents/anonymous.h).
std::string pictureSessionText(const scene::Scene& scene, const std::filesystem::path& folder,
                               const volume::Patient& patient = {});
// Parses a session. `file` is for error messages. Throws base::Error{input} with the JSON path or byte of the
// error.
scene::Scene parseSession(const std::string& text, const std::string& file, const StoredFolders& folders);

// Saves under a temporary name, then renames.
void saveSession(const scene::Scene& scene, const std::filesystem::path& file);
scene::Scene loadSession(const std::filesystem::path& file);  // .isolux, .json, .png or .exr

// Returns whether the file looks like one for loadSession() (by content).
bool isSession(const std::filesystem::path& file);

}  // namespace isolux::app
