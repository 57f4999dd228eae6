#include "volume/read/open_chunked.h"

#include <cmath>
#include <filesystem>

#include "base/error.h"
#include "volume/read/input/read_options.h"
#include "volume/read/open_arrays.h"
#include "volume/read/plain_file.h"
#include "volume/read/step_files.h"

namespace isolux::volume {

namespace {

void checkPart(const ChunkedFacts& facts, const scene::Source& source) {
  const auto refuse = [&](const char* setting, const char* what, int asked, int has) {
    throw base::Error(base::ErrorKind::usage, source.path, setting,
                      std::string(what) + " " + std::to_string(asked) + " does not exist; the file has " +
                          std::to_string(has) + " (0 is the first)");
  };
  if (source.component >= facts.channels)
    refuse("source.component", "channel", source.component, facts.channels);
  if (source.timeStep < 0 || source.timeStep >= facts.times)
    refuse("source.time_step", "time step", static_cast<int>(source.timeStep), facts.times);
}

}  // namespace

std::shared_ptr<const ChunkedVolume> openChunked(const scene::Source& source, std::string& reason,
                                                 base::Progress& progress) {
  std::error_code ignored;
  if (source.path.starts_with("phantom:")) {
    reason = "a phantom is not a file";
    return nullptr;
  }
  if (source.csg != scene::Csg::none) {
    reason = "a second volume is combined with it (source.csg)";
    return nullptr;
  }
  if (source.timeStep != std::floor(source.timeStep)) {
    reason = "two time steps are blended (source.time_step)";
    return nullptr;
  }
  if (!stepFiles(source.path).empty()) {
    reason = "its time steps are files of their own";
    return nullptr;
  }
  if (source.component < 0) {
    reason = "it is read as a magnitude (source.component)";
    return nullptr;
  }
  std::shared_ptr<const ChunkedVolume> file;
  if (source.raw.empty()) file = openArrays(source.path, source.series, progress);
  if (!file && std::filesystem::is_directory(source.path, ignored)) {
    reason = "it is a folder";
    return nullptr;
  }
  if (!file) file = openPlainFile(source.path, readOptions(source), reason);
  if (file) checkPart(file->facts(), source);
  return file;
}

bool isReadInParts(const scene::Source& source, base::Progress& progress) {
  try {
    std::string reason;
    return openChunked(source, reason, progress) != nullptr;
  } catch (const base::Error&) {
    return false;
  }
}

}  // namespace isolux::volume
