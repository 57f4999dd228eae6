#include "volume/large/glimpse.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "volume/large/index_file.h"
#include "volume/parallel/parallel_steps.h"
#include "volume/read/input/chunked_header.h"
#include "volume/read/input/payload.h"
#include "volume/read/open_chunked.h"
#include "volume/voxels/stored_type.h"

namespace isolux::volume {

namespace {

// Which voxels of a level of the file.
struct Samples {
  std::size_t level = 0;
  glm::ivec3 step{1}, first{0}, dims{0};
};

std::optional<Samples> samplesOf(const ChunkedFacts& facts, std::size_t most) {
  for (std::size_t level = 1; level < facts.levels.size(); ++level)
    if (facts.levels[level].geometry.voxelCount() <= most)
      return Samples{level, glm::ivec3(1), glm::ivec3(0), facts.levels[level].geometry.dims};
  if (!facts.levels.front().cheapParts) return std::nullopt;
  Samples samples;
  const glm::ivec3 dims = facts.levels.front().geometry.dims;
  samples.step = glm::max((dims + kGlimpseAxis - 1) / kGlimpseAxis, glm::ivec3(1));
  samples.first = (samples.step - 1) / 2;
  samples.dims = (dims - samples.first + samples.step - 1) / samples.step;
  return samples;
}

GridGeometry geometryOf(const ChunkedFacts& facts, const Samples& samples) {
  GridGeometry geometry = facts.levels[samples.level].geometry;
  geometry.dims = samples.dims;
  geometry.worldFromVoxel = glm::scale(glm::translate(geometry.worldFromVoxel, glm::dvec3(samples.first)),
                                       glm::dvec3(samples.step));
  return geometry;
}

// A row of the file at a time.
template <class T>
std::vector<T> readSamples(const ChunkedVolume& file, VolumePart part, const Samples& samples,
                           base::Progress& progress) {
  const auto nx = static_cast<std::size_t>(samples.dims.x), ny = static_cast<std::size_t>(samples.dims.y);
  std::vector<T> voxels(nx * ny * static_cast<std::size_t>(samples.dims.z));
  const int length = (samples.dims.x - 1) * samples.step.x + 1;
  parallelSteps(ny * static_cast<std::size_t>(samples.dims.z), progress, {}, [&](std::size_t i) {
    const glm::ivec3 low =
        samples.first + samples.step * glm::ivec3(0, static_cast<int>(i % ny), static_cast<int>(i / ny));
    std::vector<T> row(static_cast<std::size_t>(length));
    file.read(part, samples.level, low, {length, 1, 1}, std::as_writable_bytes(std::span(row)));
    for (std::size_t x = 0; x < nx; ++x)
      voxels[i * nx + x] = row[x * static_cast<std::size_t>(samples.step.x)];
  });
  return voxels;
}

template <class T>
std::vector<T> readLevelOf(const ChunkedVolume& file, VolumePart part, const Samples& samples,
                           base::Progress& progress) {
  const ChunkedLevel& level = file.facts().levels[samples.level];
  const int layer = level.cheapParts ? 16 : std::clamp(level.chunkDims.z, 1, samples.dims.z);
  const std::size_t slice =
      static_cast<std::size_t>(samples.dims.x) * static_cast<std::size_t>(samples.dims.y);
  std::vector<T> voxels(slice * static_cast<std::size_t>(samples.dims.z));
  parallelSteps(static_cast<std::size_t>((samples.dims.z + layer - 1) / layer), progress, {},
                [&](std::size_t i) {
                  const int z = static_cast<int>(i) * layer, count = std::min(layer, samples.dims.z - z);
                  const std::span<T> slices(voxels.data() + static_cast<std::size_t>(z) * slice,
                                            static_cast<std::size_t>(count) * slice);
                  file.read(part, samples.level, {0, 0, z}, {samples.dims.x, samples.dims.y, count},
                            std::as_writable_bytes(slices));
                });
  return voxels;
}

// Blocks of an axis that one value stands for, so that there are at most so many values.
int blocksOfValue(glm::ivec3 blocks, std::size_t most) {
  int together = 1;
  const auto values = [&] { return GridGeometry{.dims = (blocks + together - 1) / together}.voxelCount(); };
  while (values() > most) ++together;
  return together;
}

std::vector<float> middlesOf(const MinMaxBlocks& blocks, glm::ivec3 dims, int together,
                             base::Progress& progress) {
  const auto nx = static_cast<std::size_t>(dims.x), ny = static_cast<std::size_t>(dims.y);
  std::vector<float> middles(nx * ny * static_cast<std::size_t>(dims.z));
  parallelSteps(ny * static_cast<std::size_t>(dims.z), progress, {}, [&](std::size_t row) {
    for (int x = 0; x < dims.x; ++x) {
      const glm::ivec3 low = together * glm::ivec3(x, static_cast<int>(row % ny), static_cast<int>(row / ny));
      const glm::ivec3 behind = glm::min(low + together, blocks.dims());
      float least = std::numeric_limits<float>::infinity(), most = -least;
      for (int bz = low.z; bz < behind.z; ++bz)
        for (int by = low.y; by < behind.y; ++by)
          for (int bx = low.x; bx < behind.x; ++bx) {
            const std::size_t block = blocks.index({bx, by, bz});
            if (blocks.maximum(block) == kUnknownMaximum) continue;
            least = std::min(least, blocks.minimum(block));
            most = std::max(most, blocks.maximum(block));
          }
      middles[row * nx + static_cast<std::size_t>(x)] =
          least <= most ? 0.5f * least + 0.5f * most : std::numeric_limits<float>::quiet_NaN();
    }
  });
  return middles;
}

std::optional<Glimpse> glimpseOfIndex(const ChunkedVolume& file, const scene::Source& source,
                                      std::size_t most, base::Progress& progress) {
  const ReadOptions options = readOptions(source);
  const std::optional<VolumeIndex> index = IndexFile(source.path, options).find(file);
  if (!index || index->blocks()->count() == 0) return std::nullopt;
  const MinMaxBlocks& blocks = *index->blocks();
  const int together = blocksOfValue(blocks.dims(), most), cells = together * blocks.blockCells();
  GridGeometry geometry = index->facts().levels.front().geometry;
  geometry.dims = (blocks.dims() + together - 1) / together;
  geometry.worldFromVoxel =
      glm::scale(glm::translate(geometry.worldFromVoxel, glm::dvec3(0.5 * cells)), glm::dvec3(cells));
  FileVoxels middles = middlesOf(blocks, geometry.dims, together, progress);
  const ImageHeader header = chunkedHeader(file.facts(), geometry, VoxelType::float32);
  return Glimpse{finishVolume(header, std::move(middles), options, progress), glm::ivec3(cells), true};
}

}  // namespace

std::optional<Glimpse> readGlimpse(const scene::Source& source, base::Progress& progress, std::size_t least,
                                   std::size_t most) {
  if (source.path.starts_with("phantom:")) return std::nullopt;
  std::string reason;
  const std::shared_ptr<const ChunkedVolume> file = openChunked(source, reason, progress);
  if (!file) return std::nullopt;
  const ChunkedFacts& facts = file->facts();
  const GridGeometry& whole = facts.levels.front().geometry;
  if (whole.voxelCount() * bytesOf(facts.storedType) < least) return std::nullopt;
  const std::optional<Samples> samples = samplesOf(facts, most);
  if (!samples) {
    std::optional<Glimpse> glimpse = glimpseOfIndex(*file, source, most, progress);
    if (glimpse) takeNames(glimpse->volume, facts);
    return glimpse;
  }
  const GridGeometry geometry = geometryOf(facts, *samples);
  const VolumePart part{static_cast<int>(source.timeStep), source.component};
  FileVoxels voxels = withStoredType(facts.storedType, [&](auto zero) -> FileVoxels {
    using T = decltype(zero);
    return samples->level == 0 ? readSamples<T>(*file, part, *samples, progress)
                               : readLevelOf<T>(*file, part, *samples, progress);
  });
  const ImageHeader header = chunkedHeader(facts, geometry, facts.storedType);
  Glimpse glimpse{finishVolume(header, std::move(voxels), readOptions(source), progress), samples->step,
                  false};
  if (samples->level > 0) glimpse.step = glm::ivec3(glm::round(geometry.spacingMm() / whole.spacingMm()));
  takeNames(glimpse.volume, facts);
  return glimpse;
}

}  // namespace isolux::volume
