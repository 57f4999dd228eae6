#include "volume/skip/cell_ranges.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "base/huge_pages.h"
#include "volume/parallel/parallel_loops.h"
#include "volume/parallel/parallel_steps.h"

namespace isolux::volume {

namespace {

constexpr std::uint8_t kMissing = 255;

// Some 2^16 voxels, evenly spread, that are not missing; ascending.
std::vector<float> sortedSample(const Grid& grid) {
  std::vector<float> sample;
  grid.visit([&](const auto& voxels) {
    // An odd step, coprime to usual row lengths.
    const std::size_t step = (voxels.size() >> 16) | 1;
    sample.reserve(voxels.size() / step + 1);
    for (std::size_t i = 0; i < voxels.size(); i += step) {
      const float v = static_cast<float>(voxels[i]);
      if (!std::isnan(v)) sample.push_back(v);
    }
  });
  std::sort(sample.begin(), sample.end());
  return sample;
}

void lesser(std::uint8_t* into, const std::uint8_t* with, int count) {
  for (int i = 0; i < count; ++i) into[i] = std::min(into[i], with[i]);
}

void greater(std::uint8_t* into, const std::uint8_t* with, int count) {
  for (int i = 0; i < count; ++i) into[i] = std::max(into[i], with[i]);
}

// One row of blocks along x: fills their cells and the first two bytes of their words.
class BlockRow {
 public:
  BlockRow(const std::uint8_t* bins, glm::ivec3 dims, int blocks)
      : bins_(bins),
        dims_(dims),
        blocks_(blocks),
        least_(static_cast<std::size_t>(4 * blocks)),
        most_(least_.size()),
        blockLeast_(least_.size()),
        blockMost_(least_.size()) {}

  void fill(int by, int bz, std::uint8_t* words, std::uint8_t* cells) {
    std::fill(blockLeast_.begin(), blockLeast_.end(), std::uint8_t{255});
    std::fill(blockMost_.begin(), blockMost_.end(), std::uint8_t{0});
    for (int dz = 0; dz < 4; ++dz)
      for (int dy = 0; dy < 4; ++dy) {
        cellRow(4 * by + dy, 4 * bz + dz);
        lesser(blockLeast_.data(), least_.data(), 4 * blocks_);
        greater(blockMost_.data(), most_.data(), 4 * blocks_);
        std::uint8_t* to = cells + std::ptrdiff_t{8} * (dz * 4 + dy);
        for (int block = 0; block < blocks_; ++block, to += 128) {
          std::uint8_t pairs[8];
          const std::size_t first = std::size_t{4} * static_cast<std::size_t>(block);
          for (std::size_t i = 0; i < 4; ++i) {
            pairs[2 * i] = least_[first + i];
            pairs[2 * i + 1] = most_[first + i];
          }
          std::memcpy(to, pairs, 8);
        }
      }
    for (int block = 0; block < blocks_; ++block, words += 4) {
      const std::ptrdiff_t first = std::ptrdiff_t{4} * block;
      words[0] = *std::min_element(blockLeast_.begin() + first, blockLeast_.begin() + first + 4);
      words[1] = *std::max_element(blockMost_.begin() + first, blockMost_.begin() + first + 4);
    }
  }

 private:
  void cellRow(int y, int z) {
    std::fill(least_.begin(), least_.end(), std::uint8_t{255});
    std::fill(most_.begin(), most_.end(), std::uint8_t{0});
    if (y > dims_.y - 2 || z > dims_.z - 2) return;
    const int count = dims_.x - 1;
    const Extent3 voxels{dims_};
    const std::uint8_t* a = bins_ + voxels.index(0, y, z);
    const std::uint8_t* b = a + voxels.row();
    const std::uint8_t* c = a + voxels.slice();
    const std::uint8_t* d = c + voxels.row();
    std::uint8_t *least = least_.data(), *most = most_.data();
    for (int x = 0; x < count; ++x) {
      const std::uint8_t lowA = std::min(a[x], a[x + 1]), highA = std::max(a[x], a[x + 1]);
      const std::uint8_t lowB = std::min(b[x], b[x + 1]), highB = std::max(b[x], b[x + 1]);
      const std::uint8_t lowC = std::min(c[x], c[x + 1]), highC = std::max(c[x], c[x + 1]);
      const std::uint8_t lowD = std::min(d[x], d[x + 1]), highD = std::max(d[x], d[x + 1]);
      const std::uint8_t high = std::max(std::max(highA, highB), std::max(highC, highD));
      const std::uint8_t low = std::min(std::min(lowA, lowB), std::min(lowC, lowD));
      least[x] = high == kMissing ? std::uint8_t{0} : low;
      most[x] = high;
    }
  }

  const std::uint8_t* bins_;
  glm::ivec3 dims_;
  int blocks_;
  std::vector<std::uint8_t> least_, most_;            // of the cells of one row
  std::vector<std::uint8_t> blockLeast_, blockMost_;  // of 16 rows
};

std::vector<std::uint8_t> binsOf(const Grid& grid, const ValueBins& bins, base::Progress& progress) {
  std::vector<std::uint8_t> result;
  resizeStoppably(result, grid.geometry().voxelCount(), progress);
  grid.visit([&](const auto& voxels) {
    using T = typename std::decay_t<decltype(voxels)>::value_type;
    // Of integers every value's bin is found once.
    std::vector<std::uint8_t> ofInteger;
    constexpr int lowest = std::is_same_v<T, float> ? 0 : static_cast<int>(std::numeric_limits<T>::lowest());
    if constexpr (!std::is_same_v<T, float>)
      for (int v = lowest; v <= static_cast<int>(std::numeric_limits<T>::max()); ++v)
        ofInteger.push_back(bins(static_cast<float>(v)));
    parallelRanges(voxels.size(), 1 << 16, [&](const Indices<std::size_t>& range) {
      if (progress.stopRequested()) return;
      for (std::size_t i = range.begin(); i != range.end(); ++i) {
        if constexpr (std::is_same_v<T, float>)
          result[i] = std::isnan(voxels[i]) ? kMissing : bins(voxels[i]);
        else
          result[i] = ofInteger[static_cast<std::size_t>(voxels[i] - lowest)];
      }
    });
  });
  progress.throwIfStopped();
  return result;
}

void replaceHidden(const VoxelMask& hidden, std::uint8_t bin, std::vector<std::uint8_t>& bins) {
  const Extent3 voxels{hidden.dims()};
  const auto words = static_cast<std::size_t>(hidden.wordsPerRow());
  parallelEach(voxels.rows(), [&](std::size_t row) {
    for (std::size_t word = 0; word < words; ++word)
      for (std::uint64_t bits = hidden.words()[row * words + word]; bits != 0; bits &= bits - 1)
        bins[row * voxels.row() + word * VoxelMask::kVoxelsPerWord +
             static_cast<std::size_t>(std::countr_zero(bits))] = bin;
  });
}

// The last two bytes of every word: the range of its block of 4^3 words.
void fillLargeBlocks(std::uint8_t* words, glm::ivec3 dims, base::Progress& progress) {
  const Extent3 large{(dims + 3) / 4};
  parallelSteps(large.rows(), progress, {}, [&](std::size_t row) {
    glm::ivec3 block = large.firstOfRow(row);
    for (; block.x < large.dims.x; ++block.x) {
      const glm::ivec3 low = 4 * block, end = glm::min(low + 4, dims);
      std::uint8_t least = 255, most = 0;
      forEachIn(low, end, [&](glm::ivec3 at) {
        const std::uint8_t* const word = words + 4 * Extent3{dims}.index(at);
        least = std::min(least, word[0]);
        most = std::max(most, word[1]);
      });
      forEachIn(low, end, [&](glm::ivec3 at) {
        std::uint8_t* const word = words + 4 * Extent3{dims}.index(at);
        word[2] = least;
        word[3] = most;
      });
    }
  });
}

glm::ivec3 blocksOf(glm::ivec3 dims) {
  return dims.x < 2 || dims.y < 2 || dims.z < 2 ? glm::ivec3(0) : (dims + 2) / 4;
}

}  // namespace

ValueBins::ValueBins(const Grid& grid) : table_(static_cast<std::size_t>(last_) + 1) {
  const std::vector<float> sample = sortedSample(grid);
  if (sample.empty()) return;
  // Without the outermost voxels: one outlier must not put all others into one bin.
  const std::size_t cut = sample.size() / 2000;
  const double low = static_cast<double>(sample[cut]);
  const double high = static_cast<double>(sample[sample.size() - 1 - cut]);
  low_ = low;
  scale_ = high > low ? last_ / (high - low) : 0.0;
  std::vector<double> weights(table_.size(), 0.5 / static_cast<double>(table_.size()));
  for (const float v : sample)
    weights[static_cast<std::size_t>(std::clamp((static_cast<double>(v) - low_) * scale_, 0.0, last_))] +=
        0.5 / static_cast<double>(sample.size());
  double before = 0.0;
  for (std::size_t i = 0; i < table_.size(); ++i) {
    table_[i] = static_cast<std::uint8_t>(std::clamp(before * 255.0, 0.0, 254.0));
    before += weights[i];
  }
}

std::size_t CellRanges::bytesOf(glm::ivec3 dims) {
  const std::size_t blocks = Extent3{blocksOf(dims)}.count();
  // Two bytes more than the cells: kernels read four at a time.
  return blocks == 0 ? 0 : 4 * blocks + 128 * blocks + 2;
}

CellRanges::CellRanges(const Grid& grid, base::Progress& progress, const VoxelMask* hidden, bool insideHigh)
    : bins_(grid) {
  const glm::ivec3 dims = grid.dims();
  blockDims_ = blocksOf(dims);
  cellBytes_ = 4 * Extent3{blockDims_}.count();
  if (cellBytes_ == 0) return;
  table_.reserve(bytesOf(dims));
  preferHugePages(table_.data(), table_.capacity(), progress);  // before anything touches them
  resizeStoppably(table_, bytesOf(dims), progress);
  std::vector<std::uint8_t> bins = binsOf(grid, bins_, progress);
  if (hidden) replaceHidden(*hidden, insideHigh ? 0 : kMissing - 1, bins);
  const Extent3 blocks{blockDims_};
  parallelRanges(blocks.rows(), 1, [&](const Indices<std::size_t>& range) {
    if (progress.stopRequested()) return;
    BlockRow row(bins.data(), dims, blockDims_.x);
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      const glm::ivec3 first = blocks.firstOfRow(i);
      const std::size_t index = blocks.index(first);
      row.fill(first.y, first.z, table_.data() + 4 * index, table_.data() + cellBytes_ + 128 * index);
    }
  });
  progress.throwIfStopped();
  fillLargeBlocks(table_.data(), blockDims_, progress);
}

}  // namespace isolux::volume
