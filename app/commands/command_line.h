// The program: parses the command line, runs a subcommand, turns every failure into one line and an exit
// code.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

// What to open the window on.
struct WindowRequest {
  scene::Scene scene;  // of PATH, the session and --set; what they leave automatic is still so
  std::string
      sessionFile;  // absolute; where the scene came from, so that Save goes there; "": from no session
  std::string recordFile;         // --record FILE
  std::vector<std::string> host;  // --set of scene::HostSettings, for this run
  // The scene once the volume is there, where --preset or a camera by name waits for it; its source does not
  // count. May throw base::Error.
  std::function<scene::Scene(const volume::PreparedVolume&)> completed = {};
};
using OpenWindow = std::function<int(const WindowRequest&)>;

// Returns the exit code (docs/reference/outputs.md). Never throws. `describeWindow`: see makeDoctor().
int runCommandLine(int argc, char** argv, const OpenWindow& openWindow,
                   const std::function<std::string()>& describeWindow = {});

}  // namespace isolux::app
