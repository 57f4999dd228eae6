#include "volume/prepared/read_source.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/number_text.h"
#include "volume/labels/label_table.h"
#include "volume/large/coarse_level.h"
#include "volume/parallel/parallel_steps.h"
#include "volume/read/input/patient.h"
#include "volume/read/input/payload.h"
#include "volume/read/plain_file.h"
#include "volume/read/reader.h"
#include "volume/read/step_files.h"
#include "volume/statistics/label_map.h"

namespace isolux::volume {

namespace {

struct Layout {
  GridGeometry geometry;
  VoxelType type = VoxelType::uint8;
};

std::optional<Layout> layoutInHeader(const scene::Source& source) {
  std::error_code ignored;
  if (std::filesystem::is_directory(source.path, ignored)) return std::nullopt;
  FileFormat format = FileFormat::unknown;
  const auto file = describedFile(source.path, readOptions(source), format);
  if (!file) return std::nullopt;
  return Layout{file->header.geometry(), file->header.type};
}

Layout layoutOf(const scene::Source& source, base::Progress& progress) {
  if (const auto layout = layoutInHeader(source)) return *layout;
  const VolumeFile file = openSource(source, progress);
  if (file.parts) return {file.parts->facts().levels.front().geometry, file.parts->facts().storedType};
  const Volume volume = file.readWhole(readOptions(source), progress);
  return {volume.grid->geometry(), volume.fileType};
}

std::string sizeText(glm::ivec3 dims) {
  return std::to_string(dims.x) + "x" + std::to_string(dims.y) + "x" + std::to_string(dims.z);
}

void checkSame(const std::string& first, const Layout& layout, const std::string& file, const Layout& its) {
  std::string differs;
  if (its.geometry.dims != layout.geometry.dims)
    differs = "size (" + sizeText(its.geometry.dims) + ", not " + sizeText(layout.geometry.dims) + ")";
  else if (its.type != layout.type)
    differs = "type (" + std::string(nameOf(its.type)) + ", not " + std::string(nameOf(layout.type)) + ")";
  else if (!its.geometry.sameAs(layout.geometry))
    differs = "spacing or position";
  else
    return;
  base::throwInput(file, "",
                   "is no time step of " + std::filesystem::path(first).filename().string() +
                       ": its voxels differ in " + differs);
}

// (1 - fraction) first + fraction second, voxel by voxel, in data values and float32; missing where either
// is. What the file states of the values of one step (noise) is not known of the blend. Both have the same
// geometry. Throws Error{memory}, Error{interrupted}.
Volume blendedSteps(Volume first, const Volume& second, double fraction, base::Progress& progress) {
  const Grid &from = *first.grid, &to = *second.grid;
  base::machineMemory().check(from.geometry().voxelCount() * sizeof(float), "the blend of two time steps",
                              "a whole source.time_step needs none");
  std::vector<float> values;
  resizeStoppably(values, from.geometry().voxelCount(), progress);
  parallelSteps(from.extent().rows(), progress, {0.0, 1.0, "blending time steps"}, [&](std::size_t row) {
    // NaN, missing, in either is NaN in the sum.
    for (glm::ivec3 at = from.extent().firstOfRow(row); at.x < from.dims().x; ++at.x)
      values[from.index(at)] =
          static_cast<float>((1.0 - fraction) * from.value(at) + fraction * to.value(at));
  });
  const auto grid = std::make_shared<Grid>(from.geometry(), std::move(values), 1.0, 0.0, progress);
  rememberPatient(grid, patientOf(first.grid));
  first.grid = grid;
  first.noise.reset();
  if (first.damage.empty()) first.damage = second.damage;
  for (const std::string& warning : second.warnings)
    if (std::ranges::find(first.warnings, warning) == first.warnings.end()) first.warnings.push_back(warning);
  return first;
}

// Throws Error{input} naming the first file whose voxels differ in number, spacing, position or type from
// those of step 0. `read` is the volume of `step`, at the level of `source`; of step 0, those files are
// compared that say so in a header.
void checkFits(const scene::Source& source, int step, const Volume& read, base::Progress& progress) {
  const auto layoutOfRead = [&] {
    return source.level == 0 ? Layout{read.grid->geometry(), read.fileType}
                             : layoutOf(sourceOfStep(source, step), progress);
  };
  const std::string first = sourceOfStep(source, 0).path;
  if (step > 0) {
    checkSame(first, layoutOf(sourceOfStep(source, 0), progress), sourceOfStep(source, step).path,
              layoutOfRead());
    return;
  }
  const Layout layout = layoutOfRead();
  for (int other = 1; other < read.timeSteps; ++other) {
    const scene::Source file = sourceOfStep(source, other);
    if (const auto its = layoutInHeader(file)) checkSame(first, layout, file.path, *its);
  }
}

// "time step 7 does not exist; ...", where it does not. A fraction needs the next step, too.
void checkStep(const scene::Source& source, int steps) {
  if (source.timeStep >= 0.0 && source.timeStep <= steps - 1) return;
  base::throwUsage(source.path, "source.time_step",
                   "time step " + base::shortestText(source.timeStep) + " does not exist; the file has " +
                       std::to_string(steps) + " (0 is the first)");
}

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

// Whether the values are labels, by `kind`, by the file or, where neither says so, by how they lie.
bool holdsLabels(const Volume& volume, scene::DataKind kind, base::Progress& progress) {
  if (kind != scene::DataKind::automatic) return kind == scene::DataKind::labels;
  if (statesLabels(volume.labelTable.get())) return true;
  return !volume.isovalue && volume.unit != "HU" && labelMapOf(*volume.grid, false, progress).has_value();
}

// Names of regions have no means: of two steps the nearer one is shown.
Volume nearerStep(Volume first, const scene::Source& source, const ReadOptions& options,
                  base::Progress& progress) {
  const double nearest = std::round(source.timeStep);
  if (nearest > source.timeStep) first = readStep(source, static_cast<int>(nearest), {}, options, progress);
  first.warnings.push_back("labels are not blended: of source.time_step " +
                           base::shortestText(source.timeStep) + " the nearer step is shown");
  noteStep(first, nearest);
  return first;
}

Volume readBlend(const scene::Source& source, const VolumeFile& first, const ReadOptions& options,
                 base::Progress& progress) {
  const int step = static_cast<int>(source.timeStep);
  const double fraction = source.timeStep - step;
  Volume volume = readStep(source, step, first, options, progress);
  if (fraction > 0.0) {
    checkStep(source, volume.timeSteps);
    if (holdsLabels(volume, source.kind, progress))
      return nearerStep(std::move(volume), source, options, progress);
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
  const Volume other = readVolume(source.csgPath, second, progress);
  if (source.csg == scene::Csg::blend &&
      (holdsLabels(result.volume, source.kind, progress) || statesLabels(other.labelTable.get())))
    base::throwUsage(source.path, "source.csg=blend", "labels are not blended; they are names of regions");
  result.volume.labelTable.reset();  // of the combination nothing is stated
  return combined(result.volume, other, {source.csg, source.csgValue, source.csgWeight}, progress);
}

}  // namespace isolux::volume
