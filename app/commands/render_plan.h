// Which pictures `isolux render` draws and into which files: volumes, and of each a series or one picture.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/series/frame_range.h"
#include "app/series/sweep.h"

namespace isolux::app {

constexpr const char* kStandardOutput = "-";

struct PlannedPicture {
  std::string out, stats;  // stats may be empty
  int index = 0;           // in the series
};
struct VolumePictures {
  std::string path;  // "": that of the session
  std::vector<PlannedPicture> pictures;
  std::string movie, moviePrefix;  // of a turntable or of time steps, in the pictures' folder; empty: none
  std::filesystem::path folder{};  // of the pictures
};
struct RenderPlan {
  std::vector<VolumePictures> volumes;
  std::optional<Sweep> sweep;
  std::string folder;  // that --out names, to be made; empty: none
};

struct RenderPlanRequest {
  std::vector<std::string> paths;  // none: one volume, of the session
  std::string out, stats, sweep;   // as on the command line
  int turntable = 0;               // views; 0: none
  FrameChoice frames{};            // of the series
};
// A volume all of whose pictures are left out has none. Throws base::Error{usage}: as parseSweep(), frames
// without a series or beyond it, several pictures for one file or for standard output, standard output that
// is a terminal.
RenderPlan makeRenderPlan(const RenderPlanRequest& request);

}  // namespace isolux::app
