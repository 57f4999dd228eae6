#include "volume/prepared/read_source.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/number_text.h"
#include "volume/large/coarse_level.h"
#include "volume/prepared/time_steps.h"
#include "volume/read/input/payload.h"
#include "volume/read/open_chunked.h"
#include "volume/read/reader.h"
#include "volume/read/step_files.h"

namespace isolux::volume {

namespace {

// What reads the rest of a file that cannot be read to its end.
std::string remedyOfDamage(const scene::Source& source, base::Progress& progress) {
  const bool helps = !source.aroundDamage && isReadInParts(source, progress);
  return helps ? "; source.around_damage=true reads the rest" : "";
}

// What reads less of a volume that is too large for memory.
std::string remedyOfSize(const scene::Source& source, base::Progress& progress) {
  const int level = levelThatFits(source, progress, source.level + 1);
  if (level <= source.level) return "";
  return "; source.level=" + std::to_string(level) + " reads a coarser level that fits";
}

// Whole files are read around damage only where there is some: it takes longer.
Volume readLevelOrVolume(const scene::Source& source, const ReadOptions& options, base::Progress& progress) {
  if (source.level > 0) return readLevel(source, progress);
  try {
    return readVolume(source.path, options, progress);
  } catch (const base::Error& error) {
    const bool tryAround = error.kind() == base::ErrorKind::input && source.aroundDamage;
    if (!tryAround || !isReadInParts(source, progress)) throw;
  }
  return readLevel(source, progress);
}

// Whoever hears that a volume cannot be read hears what can.
Volume readAsked(const scene::Source& source, const ReadOptions& options, base::Progress& progress) {
  try {
    return readLevelOrVolume(source, options, progress);
  } catch (const base::Error& error) {
    std::string remedy;
    if (error.kind() == base::ErrorKind::memory) remedy = remedyOfSize(source, progress);
    if (error.kind() == base::ErrorKind::input) remedy = remedyOfDamage(source, progress);
    if (remedy.empty()) throw;
    throw base::Error(error.kind(), error.file(), error.place(), error.reason() + remedy);
  }
}

// A whole step, of one file or of the file that holds it.
Volume readStep(const scene::Source& source, int step, ReadOptions options, base::Progress& progress) {
  const std::vector<std::string> files = stepFiles(source.path);
  const scene::Source own = sourceOfStep(source, step);
  options.timeStep = static_cast<int>(own.timeStep);
  if (files.empty()) return readAsked(own, options, progress);
  const int steps = static_cast<int>(files.size());
  checkStep(source, steps);
  Volume volume = readAsked(own, options, progress);
  if (volume.timeSteps > 1)
    base::throwInput(own.path, "",
                     "is no time step: it has " + std::to_string(volume.timeSteps) + " of its own");
  volume.timeSteps = steps;
  checkFits(source, step, volume, progress);
  return volume;
}

Volume readBlend(const scene::Source& source, const ReadOptions& options, base::Progress& progress) {
  const int step = static_cast<int>(source.timeStep);
  const double fraction = source.timeStep - step;
  Volume volume = readStep(source, step, options, progress);
  if (fraction > 0.0) {
    checkStep(source, volume.timeSteps);
    volume =
        blendedSteps(std::move(volume), readStep(source, step + 1, options, progress), fraction, progress);
  }
  noteStep(volume, source.timeStep);
  return volume;
}

}  // namespace

CsgResult readSource(const scene::Source& source, base::Progress& progress) {
  ReadOptions options = readOptions(source);
  const bool combines = source.csg != scene::Csg::none && !source.csgPath.empty();
  ReadOptions second;  // series, component and time step are the first one's
  second.meshVoxels = source.meshVoxels;
  if (combines && showsBoth(source.csg)) options.alsoHold = meshBounds(source.csgPath, second, progress);
  CsgResult result;
  result.volume = readBlend(source, options, progress);
  if (source.csg != scene::Csg::none && !combines)
    result.volume.warnings.emplace_back("source.csg_path is empty; give a second volume");
  if (!combines) return result;
  second.grid = result.volume.grid->geometry();
  return combined(result.volume, readVolume(source.csgPath, second, progress),
                  {source.csg, source.csgValue, source.csgWeight}, progress);
}

}  // namespace isolux::volume
