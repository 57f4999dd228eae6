#include "volume/large/volume_preview.h"

#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "volume/bricks/level_voxels.h"
#include "volume/large/index_file.h"
#include "volume/parallel/parallel_steps.h"
#include "volume/read/input/chunked_header.h"
#include "volume/read/input/payload.h"
#include "volume/read/volume_file.h"
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
  samples.step = glm::max((dims + kPreviewAxis - 1) / kPreviewAxis, glm::ivec3(1));
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
  const Extent3 extent{samples.dims};
  const std::size_t nx = extent.row();
  std::vector<T> voxels(extent.count());
  const int length = (samples.dims.x - 1) * samples.step.x + 1;
  parallelSteps(extent.rows(), progress, {}, [&](std::size_t i) {
    const glm::ivec3 low = samples.first + samples.step * extent.firstOfRow(i);
    std::vector<T> row(static_cast<std::size_t>(length));
    file.read(part, samples.level, low, {length, 1, 1}, std::as_writable_bytes(std::span(row)));
    for (std::size_t x = 0; x < nx; ++x)
      voxels[i * nx + x] = row[x * static_cast<std::size_t>(samples.step.x)];
  });
  return voxels;
}

// Blocks of an axis that one value stands for, so that there are at most so many values.
int blocksOfValue(glm::ivec3 blocks, std::size_t most) {
  int together = 1;
  while (Extent3{(blocks + together - 1) / together}.count() > most) ++together;
  return together;
}

std::vector<float> middlesOf(const MinMaxBlocks& blocks, glm::ivec3 dims, int together,
                             base::Progress& progress) {
  const Extent3 extent{dims};
  std::vector<float> middles(extent.count());
  parallelSteps(extent.rows(), progress, {}, [&](std::size_t row) {
    for (glm::ivec3 at = extent.firstOfRow(row); at.x < dims.x; ++at.x) {
      const glm::ivec3 low = together * at;
      Bounds<float> range;
      forEachIn(low, glm::min(low + together, blocks.dims()), [&](glm::ivec3 block) {
        const std::size_t i = blocks.index(block);
        if (blocks.maximum(i) != kUnknownMaximum) range.add({blocks.minimum(i), blocks.maximum(i)});
      });
      middles[extent.index(at)] = range.low <= range.high ? 0.5f * range.low + 0.5f * range.high
                                                          : std::numeric_limits<float>::quiet_NaN();
    }
  });
  return middles;
}

std::optional<VolumePreview> previewOfIndex(const ChunkedVolume& file, const scene::Source& source,
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
  return VolumePreview{finishVolume(header, std::move(middles), options, progress), glm::ivec3(cells), true};
}

}  // namespace

std::optional<VolumePreview> readVolumePreview(const scene::Source& source, base::Progress& progress,
                                               std::size_t least, std::size_t most) {
  const std::shared_ptr<const ChunkedVolume> file = openSource(source, progress).parts;
  if (!file) return std::nullopt;
  const ChunkedFacts& facts = file->facts();
  const GridGeometry& whole = facts.levels.front().geometry;
  if (whole.voxelCount() * bytesOf(facts.storedType) < least) return std::nullopt;
  const std::optional<Samples> samples = samplesOf(facts, most);
  if (!samples) {
    std::optional<VolumePreview> preview = previewOfIndex(*file, source, most, progress);
    if (preview) takeNames(preview->volume, facts);
    return preview;
  }
  const GridGeometry geometry = geometryOf(facts, *samples);
  const VolumePart part{static_cast<int>(source.timeStep), source.component};
  VoxelArray voxels =
      samples->level > 0
          ? readLevelVoxels(*file, part, {samples->level}, samples->dims, false, progress).voxels
          : withStoredType(facts.storedType, [&](auto zero) -> VoxelArray {
              return readSamples<decltype(zero)>(*file, part, *samples, progress);
            });
  const ImageHeader header = chunkedHeader(facts, geometry, facts.storedType);
  VolumePreview preview{finishVolume(header, fileVoxels(std::move(voxels)), readOptions(source), progress),
                        samples->step, false};
  if (samples->level > 0) preview.step = glm::ivec3(glm::round(geometry.spacingMm() / whole.spacingMm()));
  takeNames(preview.volume, facts);
  return preview;
}

}  // namespace isolux::volume
