// Declares what the subcommands share: their definition, the options that edit the scene, and loading with a
// progress bar.
//
// Each file of this folder declares one subcommand: a make...() that adds it to the parser and returns the
// function to run. A run() reports failure by throwing; runCommandLine() turns that into a line and an exit
// code.
#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>

#include "app/files/json_text.h"
#include "app/options/scene_options.h"
#include "app/report/notes.h"
#include "app/series/frame_range.h"
#include "base/progress.h"
#include "render/gl/gl_context.h"
#include "scene/scene.h"
#include "scene/settings/host_settings.h"
#include "volume/prepared/prepared_volume.h"

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
// `describeWindow` returns how the window would show images here; empty: it is not said.
Command makeDoctor(CLI::App& program, const std::function<std::string()>& describeWindow);
Command makeHelp(CLI::App& program);
Command makePresets(CLI::App& program);
Command makeProbe(CLI::App& program);
Command makeMeasure(CLI::App& program);
Command makeSlice(CLI::App& program);

// An option whose value --help calls `type`.
template <class T>
CLI::Option* addOption(CLI::App& parser, const char* name, T& value, const char* type,
                       const std::string& help) {
  return parser.add_option(name, value, help)->type_name(type);
}
// Checks of options, which --help does not print.
template <class T>
CLI::Validator within(T low, T high) {
  return CLI::Range(low, high).description("");
}
inline CLI::Validator oneOf(std::initializer_list<std::string> words) {
  return CLI::IsMember(words).description("");
}
// Adds PATH: what a scene is opened from. Commands that draw take a picture of the program, too.
enum class Opens { sessions, pictures };
void addPath(CLI::App& parser, std::string& path, Opens opens = Opens::sessions);
// Short forms of settings that a slice does not depend on are accepted there, too, but not listed in its
// help.
enum class Draws { surface, slice };
std::shared_ptr<SceneOptions> addSceneOptions(CLI::App& parser, Draws draws = Draws::surface);
// Adds --preset, --shift; with cameras: --view, --azimuth, --elevation, --roll, --zoom, --fit.
void addVolumeOptions(CLI::App& parser, const std::shared_ptr<SceneOptions>& options, bool cameras = true);
// Adds --threads N. The limit is in force while the parser lives.
void addThreadsOption(CLI::App& parser);
void printThreadsNote(const CLI::App& parser);  // on stderr, if --threads asks for more than available
// Adds --memory-budget SIZE: the limit of base::machineMemory() while the parser lives.
void addMemoryOption(CLI::App& parser);
int threadsInForce();  // all of the machine's, or the value of --threads
std::shared_ptr<render::ContextChoice> addContextOption(CLI::App& parser);
// Adds --frames A-B, --skip-existing.
std::shared_ptr<FrameChoice> addFrameOptions(CLI::App& parser);

std::shared_ptr<const volume::PreparedVolume> loadWithProgressBar(const scene::Source& source,
                                                                  base::Progress& progress);
// As above for a command that only draws: voxels may stay in their file (memory.voxels).
std::shared_ptr<const volume::PreparedVolume> loadWithProgressBar(const scene::Source& source,
                                                                  const scene::HostSettings& host,
                                                                  base::Progress& progress);
// Parses "i/n" of --part, 1 <= i <= n <= most. Throws Error{usage}.
std::pair<int, int> parsePart(const std::string& text, int most);

}  // namespace isolux::app
