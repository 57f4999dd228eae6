// Makes the scene that the words of a command line or of a Python call describe.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "app/files/output_guard.h"
#include "app/series/camera_request.h"
#include "base/progress.h"
#include "scene/scene.h"
#include "scene/settings/host_settings.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

// The options --set, --session and the short forms; assignments are in the order of the command line.
// --preset and cameras by name need the volume and exist only after addVolumeOptions().
struct SceneOptions {
  std::string session;
  std::vector<std::string> assignments;  // PATH=VALUE
  std::string preset;                    // a name or a file; empty: none
  double shift = 0.0;                    // of the preset's isovalues, data units
  CameraRequest camera;

  bool waitsForVolume() const { return !preset.empty() || camera.any(); }
};

// Returns whether the scene is that of a session, which is exposed as in the window: from the front.
bool startsFromSession(const std::string& path, const SceneOptions& options);

// Throws Error{usage} if neither PATH nor a session states what to open.
void requireSource(const std::string& path, const SceneOptions& options);
// Throws Error{usage} if the scene clips its first isosurface, which `command` handles only as a whole.
void refuseCuts(const scene::Scene& scene, const char* command);
// Returns the scene of the session (or the default), then PATH (a volume, a session, or an image with one;
// "": none), then the assignments.
scene::Scene sceneOf(const std::string& path, const SceneOptions& options);
// As above, with the preset between session and assignments; nothing is resolved. Throws Error{usage} with
// the reason if the preset does not apply to the volume.
scene::Scene sceneOf(const std::string& path, const SceneOptions& options,
                     const volume::PreparedVolume& volume);
// Returns that scene, resolved, with the requested camera for an image of this size.
scene::Scene resolvedSceneOf(const std::string& path, const SceneOptions& options,
                             const volume::PreparedVolume& volume, glm::ivec2 size, base::Progress& progress);
// Returns the host settings that the assignments set.
scene::HostSettings hostSettingsOf(const SceneOptions& options);
// Returns a guard for all files that `scene`, made by sceneOf() of the same arguments, is read from.
OutputGuard outputGuard(const std::string& path, const SceneOptions& options, const scene::Scene& scene);
// Adds those files to `guard`, which may know files of other scenes.
void addReads(OutputGuard& guard, const std::string& path, const SceneOptions& options,
              const scene::Scene& scene);
// Throws if the guard rejects `file` or if it cannot be written. An empty name is not checked.
void checkOutput(OutputGuard& guard, const std::string& file, const std::string& option);

// Parses "WxH", 1 to 16384 each. Throws Error{usage}.
glm::ivec2 parseSize(const std::string& text);
// Returns the size of --size; without it that of the image that the session comes from, else 1024x768.
glm::ivec2 pictureSize(const std::optional<std::string>& text, const std::string& path,
                       const SceneOptions& options);

}  // namespace isolux::app
