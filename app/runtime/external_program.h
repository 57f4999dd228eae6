// Runs another program (ffmpeg) and collects what it says.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.h"

namespace isolux::app {

// The executable of this name on $PATH; empty when there is none.
std::filesystem::path findProgram(const std::string& name);

struct ProgramResult {
  int exitCode = -1;   // 128 + n when signal n ended it; -1: it could not be started
  std::string output;  // stdout and stderr together, the last 64 KiB

  std::string lastLine() const;  // of the output, that has anything
};
// Waits for the end, with stdin closed. `folder`: the working directory, empty: the current one. A stop ends
// the program and throws Error{interrupted}.
ProgramResult runProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                         const std::filesystem::path& folder, const base::Progress& progress);

}  // namespace isolux::app
