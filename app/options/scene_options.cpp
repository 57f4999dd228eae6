#include "app/options/scene_options.h"

#include <algorithm>

#include "app/documents/session.h"
#include "app/files/files.h"
#include "app/files/image_io.h"
#include "app/presets/preset_list.h"
#include "base/decimal_text.h"
#include "base/error.h"
#include "scene/rules/automatic.h"
#include "scene/rules/needs.h"
#include "scene/settings/assignment.h"
#include "scene/settings/scene_list.h"
#include "scene/settings/settings.h"

namespace isolux::app {

namespace fs = std::filesystem;

bool startsFromSession(const std::string& path, const SceneOptions& options) {
  return !options.session.empty() || (!path.empty() && isSession(path));
}

void requireSource(const std::string& path, const SceneOptions& options) {
  if (path.empty() && options.session.empty()) base::throwUsage("", "PATH", "is required, or --session FILE");
}

void refuseCuts(const scene::Scene& scene, const char* command) {
  if (scene.surfaces.front().clipped && scene::cutsSurfaces(scene))
    base::throwUsage(
        "",
        !scene.clip.planes.empty() ? "clip.planes"
        : !scene.clip.box.empty()  ? "clip.box"
                                   : "clip.removed",
        std::string(command) + " knows no cuts; --set isosurface.clipped=false takes the whole isosurface");
}

namespace {

// The session, or the default scene, with the volume of PATH.
scene::Scene startingScene(const std::string& path, const SceneOptions& options) {
  scene::Scene scene;
  if (!options.session.empty()) scene = loadSession(options.session);
  if (!path.empty() && isSession(path)) {
    if (!options.session.empty())
      base::throwUsage(path, "", "is itself a session; give either PATH or --session");
    scene = loadSession(path);
  } else if (!path.empty()) {
    const bool same = fs::absolute(path).lexically_normal() == fs::path(scene.source.path);
    if (!same)
      scene.source = scene::Source{};  // how to read the session's volume says nothing about this one
    scene.source.path = path;
  }
  return scene;
}

void applyAssignments(scene::Scene& scene, const SceneOptions& options) {
  for (const std::string& assignment : options.assignments)
    if (!scene::isHostSetting(assignment)) scene::applyAssignment(scene, assignment);
}

bool assigns(const SceneOptions& options, std::string_view path) {
  const auto& all = options.assignments;
  return std::ranges::any_of(
      all, [&](const std::string& assignment) { return scene::pathOf(assignment) == path; });
}

bool assignsIsovalue(const SceneOptions& options) {
  return std::ranges::any_of(options.assignments, [](const std::string& assignment) {
    return scene::patternOf(scene::pathOf(assignment)) == "surfaces.#.value";
  });
}

}  // namespace

scene::Scene sceneOf(const std::string& path, const SceneOptions& options) {
  scene::Scene scene = startingScene(path, options);
  applyAssignments(scene, options);
  if (!options.camera.view.empty() && assigns(options, "camera.up"))
    base::throwUsage("", "--view", "conflicts with camera.up; use --roll to turn the image");
  if (!options.preset.empty()) findPreset(options.preset);  // an unknown one is told of before any work
  return scene;
}

scene::Scene sceneOf(const std::string& path, const SceneOptions& options,
                     const volume::PreparedVolume& volume) {
  scene::Scene scene = startingScene(path, options);
  if (!options.preset.empty()) {
    const Preset preset = findPreset(options.preset);
    const std::string reason = whyNot(preset, volume, assignsIsovalue(options));
    if (!reason.empty())
      base::throwUsage(
          volume.volume.name, "preset " + preset.name,
          "does not apply: " + reason +
              (whyNot(preset, volume, true).empty() ? "; with --isovalue it shows that value instead" : ""));
    scene = withPreset(scene, preset, volume, options.shift);
  }
  applyAssignments(scene, options);
  return scene;
}

scene::Scene resolvedSceneOf(const std::string& path, const SceneOptions& options,
                             const volume::PreparedVolume& volume, glm::ivec2 size,
                             base::Progress& progress) {
  scene::Scene scene = sceneOf(path, options, volume);
  scene.camera = requestedCamera(options.camera, scene, volume, size, progress);
  return scene::resolve(std::move(scene), volume.facts);
}

scene::HostSettings hostSettingsOf(const SceneOptions& options) {
  scene::HostSettings host;
  for (const std::string& assignment : options.assignments)
    if (scene::isHostSetting(assignment)) scene::applyAssignment(host, assignment);
  return host;
}

OutputGuard outputGuard(const std::string& path, const SceneOptions& options, const scene::Scene& scene) {
  OutputGuard guard;
  addReads(guard, path, options, scene);
  return guard;
}

void addReads(OutputGuard& guard, const std::string& path, const SceneOptions& options,
              const scene::Scene& scene) {
  guard.reads(options.session, "the session");
  if (!path.empty() && isSession(path)) guard.reads(path, "the session");
  if (isPresetFile(options.preset)) guard.reads(options.preset, "the preset");
  guard.reads(scene);
}

void checkOutput(OutputGuard& guard, const std::string& file, const std::string& option) {
  if (file.empty()) return;
  guard.writes(file, option);
  const PendingFile writable{fs::path(file)};
}

glm::ivec2 parseSize(const std::string& text) {
  const auto within = [](int side) { return side >= 1 && side <= kLargestPicture; };
  auto size = base::readTwoIntegers(text, 'x');
  if (!size) size = base::readTwoIntegers(text, 'X');
  if (size && within(size->first) && within(size->second)) return {size->first, size->second};
  base::throwUsage("", "--size", '"' + text + "\" is not WxH, 1 to 16384 pixels each");
}

glm::ivec2 pictureSize(const std::optional<std::string>& text, const std::string& path,
                       const SceneOptions& options) {
  if (text) return parseSize(*text);
  const glm::ivec2 own = pngSize(path.empty() || !options.session.empty() ? options.session : path);
  return own.x > 0 ? own : glm::ivec2(1024, 768);
}

}  // namespace isolux::app
