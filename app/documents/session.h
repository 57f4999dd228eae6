// Sessions: a Scene as versioned JSON, in a .isolux file or inside a PNG or EXR picture.
//
// {"isolux_session": 6, "program": "0.2.0", "scene": {...}}. An unknown key fails with its path, an older
// version is upgraded, a missing key takes its default. Paths of volumes and light probes are stored
// relative to the session file when they lie below the same folder, and are absolute in memory.
#pragma once

#include <filesystem>
#include <string>

#include "app/documents/stored_scene.h"
#include "scene/scene.h"

namespace isolux::app {

constexpr int sessionVersion = 8;

std::string sessionText(const scene::Scene& scene, const std::filesystem::path& folder);
// For a picture in `folder` that may be given away: names no other folder (app/documents/places.h), and not
// the patient (app/documents/anonymous.h).
std::string pictureSessionText(const scene::Scene& scene, const std::filesystem::path& folder,
                               const volume::Patient& patient = {});
// `file` is for error messages. Throws base::Error{input} with the JSON path or byte of the fault.
scene::Scene parseSession(const std::string& text, const std::string& file, const StoredFolders& folders);

void saveSession(const scene::Scene& scene, const std::filesystem::path& file);  // beside, then renamed
scene::Scene loadSession(const std::filesystem::path& file);  // .isolux, .json, .png or .exr

// True for files that loadSession() should be tried on (by content).
bool isSession(const std::filesystem::path& file);

}  // namespace isolux::app
