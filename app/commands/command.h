// What the subcommands share: how one is declared, the options that edit the scene, and loading with a
// progress bar.
//
// Each file of this folder declares one subcommand: a make...() that adds it to the parser and returns what
// to run. A run() reports failure by throwing; runCommandLine() turns that into a line and an exit code.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>

#include "app/files/json_text.h"
#include "app/files/output_guard.h"
#include "app/series/camera_wish.h"
#include "app/series/frame_range.h"
#include "base/progress.h"
#include "render/gl/gl_context.h"
#include "scene/machine.h"
#include "scene/scene.h"
#include "volume/prepared_volume.h"

namespace isolux::app {

struct Command {
  CLI::App* parser;
  std::function<void(base::Progress&)> run;
};
Command makeInfo(CLI::App& program);
Command makeRender(CLI::App& program);
Command makeBake(CLI::App& program);
Command makeMerge(CLI::App& program);
Command makeIndex(CLI::App& program);
Command makeReference(CLI::App& program);
Command makeReplay(CLI::App& program);
Command makeStudy(CLI::App& program);
Command makeMesh(CLI::App& program);
Command makePhantom(CLI::App& program);
Command makeSettings(CLI::App& program);
Command makeDoctor(CLI::App& program);
Command makePresets(CLI::App& program);
Command makeProbe(CLI::App& program);
Command makeMeasure(CLI::App& program);
Command makeSlice(CLI::App& program);

// --set, --session and the short forms; assignments stand in the order of the command line. What needs the
// volume, --preset and cameras by name, only where addVolumeOptions() has added it.
struct SceneOptions {
  std::string session;
  std::vector<std::string> assignments;  // PATH=VALUE
  std::string preset;                    // a name or a file; empty: none
  double shift = 0.0;                    // of the preset's isovalues, data units
  CameraWish camera;

  bool waitsForVolume() const { return !preset.empty() || camera.any(); }
};
// Short forms of settings that a slice does not depend on are taken there, too, but not listed in its help.
enum class Draws { surface, slice };
std::shared_ptr<SceneOptions> addSceneOptions(CLI::App& parser, Draws draws = Draws::surface);
// --preset, --shift; with cameras: --view, --azimuth, --elevation, --roll, --zoom, --fit.
void addVolumeOptions(CLI::App& parser, const std::shared_ptr<SceneOptions>& options, bool cameras = true);
// --threads N, in force as long as the returned value lives in the parser's callbacks.
void addThreadsOption(CLI::App& parser);
void printThreadsNote(const CLI::App& parser);  // on stderr, where --threads asks for more than there will be
// --memory-budget SIZE: the limit of base::machineMemory(), as long as the parser lives.
void addMemoryOption(CLI::App& parser);
int threadsInForce();  // all of the machine's, or what --threads says
std::shared_ptr<render::ContextChoice> addContextOption(CLI::App& parser);
// --frames A-B, --skip-existing.
std::shared_ptr<FrameChoice> addFrameOptions(CLI::App& parser);

// Throws Error{usage} where neither PATH nor a session says what to open.
void requireSource(const std::string& path, const SceneOptions& options);
// Throws Error{usage} where the scene cuts its first isosurface, of which `command` knows the whole only.
void refuseCuts(const scene::Scene& scene, const char* command);
// The session (or the default scene), then PATH (a volume, a session, or a picture with one; "": none), then
// the assignments.
scene::Scene sceneOf(const std::string& path, const SceneOptions& options);
// The same with the preset between session and assignments; nothing is resolved. Throws Error{usage} with
// the reason where the preset does not apply to the volume.
scene::Scene sceneOf(const std::string& path, const SceneOptions& options,
                     const volume::PreparedVolume& volume);
// That, resolved, with the camera that was wished for in a picture of this size.
scene::Scene resolvedSceneOf(const std::string& path, const SceneOptions& options,
                             const volume::PreparedVolume& volume, glm::ivec2 size, base::Progress& progress);
// What the assignments say of the machine.
scene::Machine machineOf(const SceneOptions& options);
// Knows all files that `scene`, made by sceneOf() of the same arguments, is read from.
OutputGuard outputGuard(const std::string& path, const SceneOptions& options, const scene::Scene& scene);
// The same into a guard that knows files of other scenes.
void addReads(OutputGuard& guard, const std::string& path, const SceneOptions& options,
              const scene::Scene& scene);
// Refuses `file` if the guard does, and throws if it cannot be written. An empty name: nothing to check.
void checkOutput(OutputGuard& guard, const std::string& file, const std::string& option);

std::shared_ptr<const volume::PreparedVolume> loadWithProgressBar(const scene::Source& source,
                                                                  base::Progress& progress);
// The same for a command that only draws: voxels may stay in their file (memory.voxels).
std::shared_ptr<const volume::PreparedVolume> loadWithProgressBar(const scene::Source& source,
                                                                  const scene::Machine& machine,
                                                                  base::Progress& progress);
// "isolux: note: TEXT" on stderr, one line whatever the text holds.
void printNote(const std::string& text);
// What the reader had to do, as notes on stderr: after success only, so that a failure stays one line.
void printWarnings(const volume::Volume& volume);

// "WxH", 1 to 16384 each; throws Error{usage}.
glm::ivec2 parseSize(const std::string& text);
// What --size says; without it the size of the picture that the session comes from, else 1024x768.
glm::ivec2 pictureSize(const std::optional<std::string>& text, const std::string& path,
                       const SceneOptions& options);
std::string bytesText(std::uint64_t bytes);  // "13.5 MiB"

}  // namespace isolux::app
