// What the subcommands share: how one is declared, the options that edit the scene, and loading with a
// progress bar.
//
// Each file of this folder declares one subcommand: a make...() that adds it to the parser and returns what
// to run. A run() reports failure by throwing; runCommandLine() turns that into a line and an exit code.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "render/gl_context.h"
#include "scene/progress.h"
#include "scene/scene.h"
#include "volume/prepared_volume.h"

namespace isolux::app {

struct Command {
  CLI::App* parser;
  std::function<void(scene::Progress&)> run;
};
Command makeInfo(CLI::App& program);
Command makeRender(CLI::App& program);
Command makeBake(CLI::App& program);
Command makeReference(CLI::App& program);
Command makeReplay(CLI::App& program);
Command makeStudy(CLI::App& program);
Command makePhantom(CLI::App& program);
Command makeSettings(CLI::App& program);
Command makeDoctor(CLI::App& program);

// --set, --session and the short forms; assignments stand in the order of the command line.
struct SceneOptions {
  std::string session;
  std::vector<std::string> assignments;  // PATH=VALUE
};
std::shared_ptr<SceneOptions> addSceneOptions(CLI::App& parser);
// --threads N, in force as long as the returned value lives in the parser's callbacks.
void addThreadsOption(CLI::App& parser);
// --memory-budget SIZE: the limit of scene::machineMemory(), as long as the parser lives.
void addMemoryOption(CLI::App& parser);
int threadsInForce();  // all of the machine's, or what --threads says
std::shared_ptr<render::ContextChoice> addContextOption(CLI::App& parser);

// The session (or the default scene), then PATH (a volume, a session, or a picture with one; "": none), then
// the assignments.
scene::Scene sceneOf(const std::string& path, const SceneOptions& options);

std::shared_ptr<const volume::PreparedVolume> loadWithProgressBar(const scene::Source& source,
                                                                  scene::Progress& progress);
// What the reader had to do, as notes on stderr: after success only, so that a failure stays one line.
void printWarnings(const volume::Volume& volume);

// "WxH", 1 to 16384 each; throws Error{usage}.
glm::ivec2 parseSize(const std::string& text);
std::string hashText(std::uint64_t hash);                  // 16 hex digits
std::string numberText(double value);                      // shortest that reads back the same
std::string bytesText(std::uint64_t bytes);                // "13.5 MiB"
std::string jsonText(const nlohmann::ordered_json& json);  // indented, ends in a newline
// The keys "context" and "gl": what drew a picture.
void addContext(nlohmann::ordered_json& json, const render::ContextDescription& context);

}  // namespace isolux::app
