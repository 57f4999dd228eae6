#include "volume/bricks/coarse_level.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "base/error.h"
#include "base/memory_budget.h"
#include "base/number_text.h"
#include "volume/bricks/chunked_header.h"
#include "volume/bricks/hdf5/hdf5.h"
#include "volume/bricks/open_chunked.h"
#include "volume/bricks/stored_type.h"
#include "volume/parallel_steps.h"
#include "volume/read/input/payload.h"

namespace isolux::volume {

namespace {

// The file's level that a level is made of, and how many of its voxels make one, along each axis.
struct Origin {
  std::size_t fileLevel = 0;
  int factor = 1;
};

Origin originOf(const ChunkedFacts& facts, int level) {
  const int last = static_cast<int>(facts.levels.size()) - 1, own = std::min(level, last);
  return {static_cast<std::size_t>(own), 1 << (level - own)};
}

std::string timesText(glm::dvec3 n) {
  return base::shortText(n.x) + "x" + base::shortText(n.y) + "x" + base::shortText(n.z);
}

// Voxels of the file's level that are read at a time: whole chunks and whole means, and some megabytes of
// rows.
glm::ivec3 stepOf(const ChunkedLevel& level, int factor, std::size_t voxelBytes) {
  const glm::ivec3 dims = level.geometry.dims, chunk = glm::clamp(level.chunkDims, glm::ivec3(1), dims);
  glm::ivec3 step = (chunk + factor - 1) / factor * factor;
  constexpr std::size_t worthwhile = std::size_t{2} << 20;
  for (const int axis : {1, 2})
    while (step[axis] < dims[axis] && static_cast<std::size_t>(step.x) * static_cast<std::size_t>(step.y) *
                                              static_cast<std::size_t>(step.z) * voxelBytes <
                                          worthwhile)
      step[axis] *= 2;
  return step;
}

// The mean of voxels low .. low + factor - 1 of a box whose first is `origin`; the last ones repeat.
template <class T>
T meanOf(const std::vector<T>& box, glm::ivec3 size, glm::ivec3 low, int factor) {
  double sum = 0.0;
  int known = 0;
  for (int k = 0; k < factor; ++k)
    for (int j = 0; j < factor; ++j) {
      const std::size_t row =
          (static_cast<std::size_t>(std::min(low.z + k, size.z - 1)) * static_cast<std::size_t>(size.y) +
           static_cast<std::size_t>(std::min(low.y + j, size.y - 1))) *
          static_cast<std::size_t>(size.x);
      for (int i = 0; i < factor; ++i) {
        const T value = box[row + static_cast<std::size_t>(std::min(low.x + i, size.x - 1))];
        if constexpr (std::is_floating_point_v<T>)
          if (!std::isfinite(value)) continue;
        sum += static_cast<double>(value);
        ++known;
      }
    }
  const double mean = sum / known;  // NaN where nothing is known
  if constexpr (std::is_floating_point_v<T>)
    return static_cast<T>(mean);
  else
    return static_cast<T>(std::lround(mean));
}

template <class T>
std::vector<T> readMeans(const ChunkedVolume& file, VolumePart part, Origin origin, glm::ivec3 dims,
                         base::Progress& progress) {
  const ChunkedLevel& level = file.facts().levels[origin.fileLevel];
  const glm::ivec3 from = level.geometry.dims, step = stepOf(level, origin.factor, sizeof(T));
  const glm::ivec3 steps = (from + step - 1) / step;
  std::vector<T> voxels;
  resizeStoppably(
      voxels,
      static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y) * static_cast<std::size_t>(dims.z),
      progress);
  const auto count = static_cast<std::size_t>(steps.x) * static_cast<std::size_t>(steps.y) *
                     static_cast<std::size_t>(steps.z);
  parallelSteps(count, progress, {0.0, 1.0, "reading"}, [&](std::size_t index) {
    const auto i = static_cast<int>(index);
    const glm::ivec3 low = step * glm::ivec3(i % steps.x, i / steps.x % steps.y, i / (steps.x * steps.y));
    const glm::ivec3 size = glm::min(step, from - low);
    std::vector<T> box(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                       static_cast<std::size_t>(size.z));
    file.read(part, origin.fileLevel, low, size, std::as_writable_bytes(std::span(box)));
    const glm::ivec3 first = low / origin.factor,
                     behind = glm::min(dims, (low + size + origin.factor - 1) / origin.factor);
    for (int z = first.z; z < behind.z; ++z) {
      if (progress.stopRequested()) return;
      for (int y = first.y; y < behind.y; ++y) {
        T* const row = voxels.data() + (static_cast<std::size_t>(z) * static_cast<std::size_t>(dims.y) +
                                        static_cast<std::size_t>(y)) *
                                           static_cast<std::size_t>(dims.x);
        for (int x = first.x; x < behind.x; ++x)
          row[x] = meanOf(box, size, origin.factor * glm::ivec3(x, y, z) - low, origin.factor);
      }
    }
  });
  return voxels;
}

std::shared_ptr<const ChunkedVolume> opened(const scene::Source& source, base::Progress& progress) {
  std::string reason;
  std::shared_ptr<const ChunkedVolume> file = openChunked(source, reason, progress);
  if (file) return file;
  throw base::Error(base::ErrorKind::usage, source.path, "source.level=" + std::to_string(source.level),
                    "only files that are read in parts have coarser levels: " + reason);
}

}  // namespace

int coarsestLevel(const ChunkedFacts& facts) {
  constexpr int kLeastVoxels = 8;
  const glm::ivec3 dims = facts.levels.back().geometry.dims;
  int level = static_cast<int>(facts.levels.size()) - 1;
  for (int longest = std::max({dims.x, dims.y, dims.z}); longest / 2 >= kLeastVoxels; longest /= 2) ++level;
  return level;
}

GridGeometry levelGeometry(const ChunkedFacts& facts, int level) {
  const Origin origin = originOf(facts, level);
  GridGeometry geometry = facts.levels[origin.fileLevel].geometry;
  if (origin.factor == 1) return geometry;
  const double factor = origin.factor;
  geometry.dims = (geometry.dims + origin.factor - 1) / origin.factor;
  geometry.worldFromVoxel = glm::scale(
      glm::translate(geometry.worldFromVoxel, glm::dvec3(0.5 * (factor - 1.0))), glm::dvec3(factor));
  return geometry;
}

std::size_t levelBytes(const ChunkedFacts& facts, int level) {
  const std::size_t voxels = levelGeometry(facts, level).voxelCount();
  return voxels * bytesOf(facts.storedType) + voxels / 2;
}

std::string levelNote(const ChunkedFacts& facts, int level) {
  const GridGeometry& whole = facts.levels.front().geometry;
  const GridGeometry coarse = levelGeometry(facts, level);
  const glm::dvec3 factor = coarse.spacingMm() / whole.spacingMm(), thin = 2.0 * coarse.spacingMm();
  return "level " + std::to_string(level) + ": each voxel is the mean of " + timesText(factor) +
         " of the file's " + timesText(whole.dims) + "; what is thinner than " +
         base::shortText(std::max({thin.x, thin.y, thin.z}), 3) + " mm may be missing";
}

int levelThatFits(const scene::Source& source, base::Progress& progress) {
  if (source.path.starts_with("phantom:")) return 0;
  const std::size_t left = base::machineMemory().left();
  // To open an HDF5 file takes a process: small ones are not opened twice.
  constexpr std::size_t packedAtMost = 20;
  std::error_code ignored;
  if (const auto dataset = hdf5PathOf(source.path);
      dataset && std::filesystem::file_size(dataset->file, ignored) < left / packedAtMost)
    return 0;
  try {
    std::string reason;
    const std::shared_ptr<const ChunkedVolume> file = openChunked(source, reason, progress);
    if (!file) return 0;
    const int last = coarsestLevel(file->facts());
    int level = 0;
    while (level < last && levelBytes(file->facts(), level) > left) ++level;
    return level;
  } catch (const base::Error&) {
    return 0;
  }
}

Volume readLevel(const scene::Source& source, base::Progress& progress) {
  const std::shared_ptr<const ChunkedVolume> file = opened(source, progress);
  const ChunkedFacts& facts = file->facts();
  if (source.level > coarsestLevel(facts))
    throw base::Error(base::ErrorKind::usage, source.path, "source.level",
                      "level " + std::to_string(source.level) + " is asked for; the coarsest is " +
                          std::to_string(coarsestLevel(facts)));
  const ReadOptions options = readOptions(source);
  const GridGeometry geometry = levelGeometry(facts, source.level);
  ImageHeader header = chunkedHeader(facts, geometry, facts.storedType);
  header.warnings.insert(header.warnings.begin(), levelNote(facts, source.level));
  checkBudget(header, source.path, options);
  const VolumePart part{source.timeStep, source.component};
  const Origin origin = originOf(facts, source.level);
  FileVoxels voxels = withStoredType(facts.storedType, [&](auto zero) -> FileVoxels {
    return readMeans<decltype(zero)>(*file, part, origin, geometry.dims, progress);
  });
  Volume volume = finishVolume(header, std::move(voxels), options, progress);
  volume.coarsestLevel = coarsestLevel(facts);
  volume.name = std::filesystem::path(source.path).filename().string();
  return volume;
}

}  // namespace isolux::volume
