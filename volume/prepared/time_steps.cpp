#include "volume/prepared/time_steps.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/number_text.h"
#include "volume/parallel/parallel_steps.h"
#include "volume/read/input/patient.h"
#include "volume/read/input/payload.h"
#include "volume/read/open_chunked.h"
#include "volume/read/plain_file.h"
#include "volume/read/reader.h"
#include "volume/read/step_files.h"
#include "volume/same_geometry.h"

namespace isolux::volume {

namespace {

Grid blend(const Grid& first, const Grid& second, double fraction, base::Progress& progress) {
  const glm::ivec3 dims = first.dims();
  base::machineMemory().check(first.geometry().voxelCount() * sizeof(float), "the blend of two time steps",
                              "a whole source.time_step needs none");
  std::vector<float> values;
  resizeStoppably(values, first.geometry().voxelCount(), progress);
  const auto ny = static_cast<std::size_t>(dims.y);
  parallelSteps(ny * static_cast<std::size_t>(dims.z), progress, {0.0, 1.0, "blending time steps"},
                [&](std::size_t row) {
                  const auto y = static_cast<int>(row % ny), z = static_cast<int>(row / ny);
                  for (int x = 0; x < dims.x; ++x)  // NaN, missing, in either is NaN in the sum
                    values[first.index(x, y, z)] = static_cast<float>(
                        (1.0 - fraction) * first.value(x, y, z) + fraction * second.value(x, y, z));
                });
  return {first.geometry(), std::move(values), 1.0, 0.0, progress};
}

struct Layout {
  GridGeometry geometry;
  VoxelType type = VoxelType::uint8;
};

std::optional<Layout> layoutInHeader(const scene::Source& source) {
  std::error_code ignored;
  if (std::filesystem::is_directory(source.path, ignored)) return std::nullopt;
  const auto header = headerOfPlainFile(source.path, readOptions(source));
  if (!header) return std::nullopt;
  GridGeometry geometry;
  geometry.dims = glm::ivec3(header->dims[0], header->dims[1], header->dims[2]);
  geometry.worldFromVoxel = header->worldFromVoxel;
  return Layout{geometry, header->type};
}

Layout layoutOf(const scene::Source& source, base::Progress& progress) {
  if (const auto layout = layoutInHeader(source)) return *layout;
  std::string reason;
  if (const auto file = openChunked(source, reason, progress))
    return {file->facts().levels.front().geometry, file->facts().storedType};
  const Volume volume = readVolume(source.path, readOptions(source), progress);
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
  else if (!sameGeometry(its.geometry, layout.geometry))
    differs = "spacing or position";
  else
    return;
  base::throwInput(file, "",
                   "is no time step of " + std::filesystem::path(first).filename().string() +
                       ": its voxels differ in " + differs);
}

}  // namespace

Volume blendedSteps(Volume first, const Volume& second, double fraction, base::Progress& progress) {
  const auto grid = std::make_shared<Grid>(blend(*first.grid, *second.grid, fraction, progress));
  rememberPatient(grid, patientOf(first.grid));
  first.grid = grid;
  first.noise.reset();
  if (first.damage.empty()) first.damage = second.damage;
  for (const std::string& warning : second.warnings)
    if (std::find(first.warnings.begin(), first.warnings.end(), warning) == first.warnings.end())
      first.warnings.push_back(warning);
  return first;
}

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

void checkStep(const scene::Source& source, int steps) {
  if (source.timeStep >= 0.0 && source.timeStep <= steps - 1) return;
  throw base::Error(base::ErrorKind::usage, source.path, "source.time_step",
                    "time step " + base::shortestText(source.timeStep) + " does not exist; the file has " +
                        std::to_string(steps) + " (0 is the first)");
}

}  // namespace isolux::volume
