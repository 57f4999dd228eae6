#include "volume/skip/min_max_blocks.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "volume/parallel/parallel_steps.h"

namespace isolux::volume {

namespace {

// Minimum and maximum of the voxels [low, high] (inclusive); comparisons with NaN are false, so missing
// voxels do not count.
template <class T>
void blockRange(const T* voxels, glm::ivec3 dims, glm::ivec3 low, glm::ivec3 high, float& minimum,
                float& maximum) {
  T least = std::numeric_limits<T>::max(), most = std::numeric_limits<T>::lowest();
  const int width = high.x - low.x + 1;
  for (int z = low.z; z <= high.z; ++z) {
    for (int y = low.y; y <= high.y; ++y) {
      const T* row = voxels + Extent3{dims}.index(low.x, y, z);
      for (int x = 0; x < width; ++x) {
        least = row[x] < least ? row[x] : least;
        most = row[x] > most ? row[x] : most;
      }
    }
  }
  minimum = static_cast<float>(least);
  maximum = static_cast<float>(most);
}

}  // namespace

std::vector<std::uint8_t> cellBlocksIn(std::span<const std::uint8_t> ofVoxels, glm::ivec3 voxels) {
  const Extent3 blocks{(voxels + kBlockCells - 1) / kBlockCells},
      cells{(glm::max(voxels - 1, glm::ivec3(0)) + kBlockCells - 1) / kBlockCells};
  assert(ofVoxels.size() == blocks.count());
  std::vector<std::uint8_t> reach(cells.count());
  for (std::size_t block = 0; block < ofVoxels.size(); ++block) {
    if (ofVoxels[block] == 0) continue;
    const glm::ivec3 at = blocks.at(block);  // whose first voxels are the last of the blocks before
    forEachIn(glm::max(at - 1, 0), glm::min(at + 1, cells.dims),
              [&](glm::ivec3 cell) { reach[cells.index(cell)] = 1; });
  }
  return reach;
}

MinMaxBlocks::MinMaxBlocks(glm::ivec3 voxels, int blockCells) : blockCells_(blockCells) {
  assert(blockCells == 4 || blockCells == 8);
  const glm::ivec3 cells = glm::max(voxels - 1, glm::ivec3(0));
  dims_ = (cells + blockCells - 1) / blockCells;
  minimum_.resize(Extent3{dims_}.count(), std::numeric_limits<float>::max());
  maximum_.resize(minimum_.size(), std::numeric_limits<float>::lowest());
}

MinMaxBlocks::MinMaxBlocks(const Grid& grid, int blockCells, base::Progress& progress)
    : MinMaxBlocks(grid.dims(), blockCells) {
  grid.visit([&](const auto& voxels) { fill(voxels, grid, 0, progress); });
}

MinMaxBlocks::MinMaxBlocks(const MinMaxBlocks& before, const Grid& grid,
                           std::span<const std::uint8_t> changed, base::Progress& progress)
    : MinMaxBlocks(before) {
  assert(changed.size() == count());
  grid.visit([&](const auto& voxels) { fill(voxels, grid, 0, progress, changed); });
}

MinMaxBlocks MinMaxBlocks::ofCubic(const Grid& grid, const Coefficients* coefficients, int blockCells,
                                   base::Progress& progress) {
  MinMaxBlocks blocks(grid.dims(), blockCells);
  visitSpline(grid, coefficients, [&](const auto& samples) { blocks.fill(samples, grid, 1, progress); });
  return blocks;
}

template <class T>
void MinMaxBlocks::fill(const std::vector<T>& voxels, const Grid& grid, int apron, base::Progress& progress,
                        std::span<const std::uint8_t> changed) {
  if (count() == 0) return;
  parallelSteps(Extent3{dims_}.rows(), progress, {}, [&](std::size_t row) {
    glm::ivec3 block = Extent3{dims_}.firstOfRow(row);
    for (; block.x < dims_.x; ++block.x) {
      const std::size_t i = index(block);
      if (!changed.empty() && changed[i] == 0) continue;
      const glm::ivec3 first = block * blockCells_;
      const glm::ivec3 low = glm::max(first - apron, glm::ivec3(0));
      const glm::ivec3 high = glm::min(first + blockCells_ + apron, grid.dims() - 1);
      blockRange(voxels.data(), grid.dims(), low, high, minimum_[i], maximum_[i]);
    }
  });
}

template <class T>
void MinMaxBlocks::setLayers(int layer, std::span<const T> slab, glm::ivec3 voxels,
                             base::Progress& progress) {
  const std::size_t slice = Extent3{voxels}.slice();
  if (count() == 0 || slice == 0) return;
  const int first = layer * blockCells_, slices = static_cast<int>(slab.size() / slice);
  const int behind = std::min(first + slices, voxels.z);  // the first slice that is not given
  const int layers = behind == voxels.z ? dims_.z - layer : (slices - 1) / blockCells_;
  parallelEach(std::max(layers, 0) * dims_.y, [&](int row) {
    if (progress.stopRequested()) return;
    for (int x = 0; x < dims_.x; ++x) {
      const glm::ivec3 block(x, row % dims_.y, layer + row / dims_.y);
      const glm::ivec3 low = block * blockCells_, high = glm::min(low + blockCells_, voxels - 1);
      const glm::ivec3 down(0, 0, first);
      const std::size_t i = index(block);
      blockRange(slab.data(), voxels, low - down, high - down, minimum_[i], maximum_[i]);
    }
  });
  progress.throwIfStopped();
}

template void MinMaxBlocks::setLayers(int, std::span<const std::int8_t>, glm::ivec3, base::Progress&);
template void MinMaxBlocks::setLayers(int, std::span<const std::uint8_t>, glm::ivec3, base::Progress&);
template void MinMaxBlocks::setLayers(int, std::span<const std::int16_t>, glm::ivec3, base::Progress&);
template void MinMaxBlocks::setLayers(int, std::span<const std::uint16_t>, glm::ivec3, base::Progress&);
template void MinMaxBlocks::setLayers(int, std::span<const float>, glm::ivec3, base::Progress&);

std::size_t MinMaxBlocks::activeBlocks(float storedIsovalue, std::vector<std::uint8_t>& flags) const {
  flags.resize(count());
  std::size_t found = 0;
  for (std::size_t block = 0; block < count(); ++block) {
    flags[block] = active(block, storedIsovalue) ? 1 : 0;
    found += flags[block];
  }
  return found;
}

}  // namespace isolux::volume
