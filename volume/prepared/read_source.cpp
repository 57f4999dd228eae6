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
#include "volume/read/reader.h"
#include "volume/read/step_files.h"

namespace isolux::volume {

namespace {

// Whole files are read around damage only where there is some: it takes longer.
Volume readLevelOrWhole(const scene::Source& source, const VolumeFile& file, const ReadOptions& options,
                        base::Progress& progress) {
  if (source.level > 0) return readLevel(file, source, progress);
  try {
    return file.readWhole(options, progress);
  } catch (const base::Error& error) {
    if (error.kind() != base::ErrorKind::input || !source.aroundDamage || !file.parts) throw;
  }
  return readLevel(file, source, progress);
}

// Whoever hears that a volume cannot be read hears what can.
Volume readAsked(const scene::Source& source, const VolumeFile& file, const ReadOptions& options,
                 base::Progress& progress) {
  try {
    return readLevelOrWhole(source, file, options, progress);
  } catch (const base::Error& error) {
    std::string remedy;
    const int level = levelThatFits(file, source.level + 1);
    if (error.kind() == base::ErrorKind::memory && level > source.level)
      remedy = "; source.level=" + std::to_string(level) + " reads a coarser level that fits";
    if (error.kind() == base::ErrorKind::input && !source.aroundDamage && file.parts)
      remedy = "; source.around_damage=true reads the rest";
    if (remedy.empty()) throw;
    throw base::Error(error.kind(), error.file(), error.place(), error.reason() + remedy);
  }
}

// A whole step, of one file or of the file that holds it. `open`: that file; without `readWhole` it is
// opened.
Volume readStep(const scene::Source& source, int step, VolumeFile open, ReadOptions options,
                base::Progress& progress) {
  const int steps = static_cast<int>(stepFiles(source.path).size());
  const scene::Source own = sourceOfStep(source, step);
  options.timeStep = static_cast<int>(own.timeStep);
  if (steps > 0) checkStep(source, steps);
  if (!open.readWhole) open = openSource(own, progress);
  Volume volume = readAsked(own, open, options, progress);
  if (steps == 0) return volume;
  if (volume.timeSteps > 1)
    base::throwInput(own.path, "",
                     "is no time step: it has " + std::to_string(volume.timeSteps) + " of its own");
  volume.timeSteps = steps;
  checkFits(source, step, volume, progress);
  return volume;
}

Volume readBlend(const scene::Source& source, const VolumeFile& first, const ReadOptions& options,
                 base::Progress& progress) {
  const int step = static_cast<int>(source.timeStep);
  const double fraction = source.timeStep - step;
  Volume volume = readStep(source, step, first, options, progress);
  if (fraction > 0.0) {
    checkStep(source, volume.timeSteps);
    volume = blendedSteps(std::move(volume), readStep(source, step + 1, {}, options, progress), fraction,
                          progress);
  }
  noteStep(volume, source.timeStep);
  return volume;
}

}  // namespace

CsgResult readSource(const scene::Source& source, const VolumeFile& first, base::Progress& progress) {
  ReadOptions options = readOptions(source);
  const bool combines = source.csg != scene::Csg::none && !source.csgPath.empty();
  ReadOptions second;  // series, component and time step are the first one's
  second.meshVoxels = source.meshVoxels;
  if (combines && showsBoth(source.csg)) options.alsoHold = meshBounds(source.csgPath, second, progress);
  CsgResult result;
  result.volume = readBlend(source, first, options, progress);
  if (source.csg != scene::Csg::none && !combines)
    result.volume.warnings.emplace_back("source.csg_path is empty; give a second volume");
  if (!combines) return result;
  second.grid = result.volume.grid->geometry();
  return combined(result.volume, readVolume(source.csgPath, second, progress),
                  {source.csg, source.csgValue, source.csgWeight}, progress);
}

}  // namespace isolux::volume
