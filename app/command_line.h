// The program: parses the command line, runs a subcommand, turns every failure into one line and an exit
// code.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace isolux::app {

// What to open the window on.
struct WindowRequest {
  scene::Scene scene;  // source.path set from PATH; overrides not yet applied to automatic values
  std::vector<std::string> assignments;  // --set and its short forms, in order; apply after loading
  std::string recordFile;                // --record FILE
};
using OpenWindow = std::function<int(const WindowRequest&)>;

// Returns the exit code (docs/commands.md). Never throws.
int runCommandLine(int argc, char** argv, const OpenWindow& openWindow);

}  // namespace isolux::app
