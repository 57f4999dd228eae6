#include "volume/large/lost_structure.h"

#include <atomic>

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include "volume/large/index_file.h"
#include "volume/parallel/parallel_steps.h"
#include "volume/read/volume_file.h"

namespace isolux::volume {

namespace {

// Whether the level's field, between `low` and `high` in its voxel coordinates, has both sides. Levels lie
// along the axes of level 0.
bool levelCrosses(const Grid& level, glm::dvec3 low, glm::dvec3 high, double storedIsovalue) {
  constexpr double kRounding = 1e-6;  // voxels
  const glm::dvec3 last(level.dims() - 1);
  const glm::ivec3 from(glm::clamp(glm::floor(low + kRounding), glm::dvec3(0.0), last)),
      to(glm::clamp(glm::ceil(high - kRounding), glm::dvec3(0.0), last));
  bool below = false, above = false;
  for (int z = from.z; z <= to.z; ++z)
    for (int y = from.y; y <= to.y; ++y)
      for (int x = from.x; x <= to.x; ++x) {
        const double value = static_cast<double>(level.stored(x, y, z));  // NaN: neither
        below = below || value < storedIsovalue;
        above = above || value >= storedIsovalue;
        if (below && above) return true;
      }
  return false;
}

}  // namespace

std::optional<IndexedVolume> indexedVolume(scene::Source source, base::Progress& progress) {
  source.level = 0;
  const std::shared_ptr<const ChunkedVolume> file = openSource(source, progress).parts;
  if (!file) return std::nullopt;
  const std::optional<VolumeIndex> index = IndexFile(source.path, readOptions(source)).find(*file);
  if (!index) return std::nullopt;
  return IndexedVolume{file->facts().levels.front().geometry, index->blocks()};
}

LostStructure::LostStructure(const IndexedVolume& whole, const Grid& level, std::span<const double> isovalues,
                             base::Progress& progress)
    : dims_(whole.geometry.dims), blocks_(whole.blocks), gaps_(whole.blocks->count(), 0) {
  if (gaps_.empty()) return;
  const glm::dmat4 levelFromWhole =
      glm::inverse(level.geometry().worldFromVoxel) * whole.geometry.worldFromVoxel;
  const int cells = blocks_->blockCells();
  const glm::ivec3 blocks = blocks_->dims();
  std::atomic<std::size_t> count{0};
  parallelSteps(static_cast<std::size_t>(blocks.z), progress, {0.0, 1.0, "comparing levels"},
                [&](std::size_t z) {
                  const int layer = static_cast<int>(z);
                  forEachIn({0, 0, layer}, {blocks.x, blocks.y, layer + 1}, [&](glm::ivec3 block) {
                    const glm::ivec3 low = block * cells, high = glm::min(low + cells, dims_ - 1);
                    const std::size_t index = blocks_->index(block);
                    const auto inLevel = [&](glm::ivec3 voxel) {
                      return glm::dvec3(levelFromWhole * glm::dvec4(voxel, 1.0));
                    };
                    for (const double isovalue : isovalues) {
                      const double stored = (isovalue - level.intercept()) / level.slope();
                      if (!blocks_->active(index, static_cast<float>(stored))) continue;
                      if (levelCrosses(level, inLevel(low), inLevel(high), stored)) continue;
                      gaps_[index] = 1;
                      ++count;
                      break;
                    }
                  });
                });
  count_ = count;
}

bool LostStructure::on(const Ray& ray) const {
  if (count_ == 0 || !ray.valid()) return false;
  const int cells = blocks_->blockCells();
  CellWalk walk(dims_, ray);
  for (bool more = walk.inside(); more;) {
    const glm::ivec3 block = walk.cell() / cells, low = block * cells;
    if (gaps_[blocks_->index(block)]) return true;
    more = walk.leave(low, glm::min(low + cells, dims_ - 1));
  }
  return false;
}

}  // namespace isolux::volume
