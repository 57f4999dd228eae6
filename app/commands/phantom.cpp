// isolux phantom NAME --size N --out FILE: writes a built-in test volume; `isolux phantom list` names them.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/commands/command.h"
#include "app/files/files.h"
#include "app/runtime/progress_bar.h"
#include "base/error.h"
#include "base/number_text.h"
#include "base/words.h"
#include "volume/phantom/phantom.h"
#include "volume/write/writer.h"

namespace isolux::app {

namespace {

namespace fs = std::filesystem;

struct PhantomOptions {
  volume::PhantomRequest request;
  std::string out;
};

void printPhantoms() {
  std::size_t width = 4;
  for (const volume::PhantomInfo& info : volume::phantoms()) width = std::max(width, info.name.size());
  std::printf("%-*s  %5s  %9s  %-4s  %s\n", static_cast<int>(width), "name", "size", "isovalue", "unit",
              "meaning");
  for (const volume::PhantomInfo& info : volume::phantoms())
    std::printf("%-*s  %5d  %9s  %-4s  %s\n", static_cast<int>(width), std::string(info.name).c_str(),
                info.defaultSize, base::shortestText(info.isovalue).c_str(), std::string(info.unit).c_str(),
                std::string(info.meaning).c_str());
  std::fflush(stdout);
}

void checkName(const std::string& name) {
  std::vector<std::string> names{"list"};
  for (const volume::PhantomInfo& info : volume::phantoms()) names.emplace_back(info.name);
  if (std::ranges::find(names, name) != names.end()) return;
  base::throwUsage("", name,
                   "no such phantom" + base::didYouMean(name, names, "; `isolux phantom list` names them"));
}

// The voxels of NAME.mhd go to NAME.raw, which nobody has named: if it is not that of an older NAME.mhd, it
// may be a scan.
void checkVoxelFile(const fs::path& out) {
  if (out.extension() != ".mhd") return;
  const fs::path voxels = fs::path(out).replace_extension(".raw");
  std::error_code ignored;
  if (fs::exists(voxels, ignored) && !fs::exists(out, ignored))
    base::throwInput(out.string(), "", "its voxels would replace the file " + voxels.filename().string());
}

void runPhantom(const PhantomOptions& options, base::Progress& progress) {
  checkName(options.request.name);
  if (options.request.name == "list") {
    printPhantoms();
    return;
  }
  if (options.out.empty()) base::throwUsage("", "--out", "is required");
  if (!std::isfinite(options.request.noise)) base::throwUsage("", "--noise", "must be finite");
  { const PendingFile writable{fs::path(options.out)}; }
  checkVoxelFile(options.out);
  const ProgressBar bar(progress);
  const volume::Grid grid = volume::makePhantom(options.request, progress);
  progress.throwIfStopped();
  volume::writeVolume(grid, options.out, volume::phantomNamed(options.request.name).axes);
}

}  // namespace

Command makePhantom(CLI::App& program) {
  CLI::App* const parser =
      program.add_subcommand("phantom", "Write a built-in test volume to a file, or list them");
  auto options = std::make_shared<PhantomOptions>();
  volume::PhantomRequest& request = options->request;
  request.name.clear();
  parser->add_option("NAME", request.name, "Name of the phantom; `isolux phantom list` prints all")
      ->required();
  addOption(*parser, "--size", request.size, "N", "Voxels per axis; default: the phantom's own")
      ->check(within(2, 1024));
  addOption(*parser, "--out", options->out, "FILE", "File to write: .mhd, .mha, .nrrd or .vti");
  addOption(*parser, "--noise", request.noise, "SIGMA",
            "Standard deviation of added Gaussian noise, in data units; default 0")
      ->check(CLI::NonNegativeNumber.description(""));
  addOption(*parser, "--seed", request.seed, "N", "Seed of the noise; default 1");
  addThreadsOption(*parser);
  parser->footer(
      "Examples:\n"
      "  isolux phantom list\n"
      "  isolux phantom head --size 192 --noise 15 --out head.mha");
  return {parser, [options](base::Progress& progress) { runPhantom(*options, progress); }};
}

}  // namespace isolux::app
