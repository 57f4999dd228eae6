#include "volume/skip/box_bounds.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "volume/parallel/parallel_loops.h"
#include "volume/parallel/parallel_steps.h"

namespace isolux::volume {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr int kBoxes = 4;             // per axis of a block
constexpr double kSteps = 65535.0;    // of bounds, between the least and the greatest value
constexpr int kMostRows = 8 + 1 + 2;  // voxels of a block on an axis, with an apron of 1

using Range = Bounds<float>;

Range rangeOf(const Grid& grid) {
  if (grid.missingCount() == grid.geometry().voxelCount()) return {};
  return {static_cast<float>(grid.storedMinimum()), static_cast<float>(grid.storedMaximum())};
}

// An index that fits an int: blocks are small.
constexpr std::size_t boxIndex(int index) {
  return static_cast<std::size_t>(index);
}

constexpr std::size_t kBoxesOfBlock = boxIndex(kBoxes * kBoxes * kBoxes);

// The ranges of the boxes of one block, one axis after the other: rows to boxes along x, then along y, then
// z.
template <class T>
class BlockScan {
 public:
  BlockScan(const std::vector<T>& voxels, glm::ivec3 dims, glm::ivec3 first, int apron)
      : voxels_(voxels),
        dims_(dims),
        first_(first),
        span_(BoxBounds::kBoxCells + 1 + 2 * apron),
        apron_(apron) {}

  // Box (x, y, z); infinite in both directions where a voxel is missing.
  std::array<Range, kBoxesOfBlock> boxes() const {
    const int rows = BoxBounds::kBlockCells + 1 + 2 * apron_;
    std::array<Range, boxIndex(kBoxes * kMostRows * kMostRows)> alongX;
    for (int z = 0; z < rows; ++z)
      for (int y = 0; y < rows; ++y) scanRow(y, z, &alongX[boxIndex((z * rows + y) * kBoxes)]);
    std::array<Range, boxIndex(kBoxes * kBoxes * kMostRows)> alongY;
    for (int z = 0; z < rows; ++z)
      for (int box = 0; box < kBoxes; ++box)
        for (int x = 0; x < kBoxes; ++x) {
          Range& range = alongY[boxIndex((z * kBoxes + box) * kBoxes + x)];
          for (int y = 2 * box; y < 2 * box + span_; ++y)
            range.add(alongX[boxIndex((z * rows + y) * kBoxes + x)]);
        }
    std::array<Range, kBoxesOfBlock> result;
    for (int box = 0; box < kBoxes; ++box)
      for (int yx = 0; yx < kBoxes * kBoxes; ++yx)
        for (int z = 2 * box; z < 2 * box + span_; ++z)
          result[boxIndex(box * kBoxes * kBoxes + yx)].add(alongY[boxIndex(z * kBoxes * kBoxes + yx)]);
    return result;
  }

 private:
  void scanRow(int y, int z, Range* boxes) const {
    const T* row = voxels_.data() + Extent3{dims_}.index(0, std::clamp(first_.y - apron_ + y, 0, dims_.y - 1),
                                                         std::clamp(first_.z - apron_ + z, 0, dims_.z - 1));
    for (int box = 0; box < kBoxes; ++box)
      for (int x = 2 * box; x < 2 * box + span_; ++x) {
        const auto v = static_cast<float>(row[std::clamp(first_.x - apron_ + x, 0, dims_.x - 1)]);
        boxes[box].add(std::isnan(v) ? Range{-kInfinity, kInfinity} : Range{v, v});
      }
  }

  const std::vector<T>& voxels_;
  glm::ivec3 dims_, first_;
  int span_, apron_;
};

}  // namespace

BoxBounds::BoxBounds(glm::ivec3 voxels) {
  const glm::ivec3 cells = glm::max(voxels - 1, glm::ivec3(0));
  dims_ = (cells + kBlockCells - 1) / kBlockCells;
}

void BoxBounds::place(const MinMaxBlocks* known, const base::Progress& progress) {
  places_.resize(Extent3{dims_}.count());
  std::uint32_t count = 0;
  for (std::size_t block = 0; block < places_.size(); ++block) {
    const bool isConstant = known && !(known->minimum(block) < known->maximum(block));
    places_[block] = isConstant ? kNoPlace : count++;
  }
  held_ = base::machineMemory().reserve(count * sizeof(Bounds) + places_.size() * sizeof(std::uint32_t),
                                        "min-max blocks", "a volume of fewer voxels needs less");
  resizeStoppably(bounds_, count, progress);
}

BoxBounds::BoxBounds(const Grid& grid, const MinMaxBlocks& blocks, base::Progress& progress)
    : BoxBounds(grid.dims()) {
  assert(blocks.blockCells() == kBlockCells);
  const MinMaxBlocks* const known = grid.missingCount() == 0 ? &blocks : nullptr;  // else of some voxels
  grid.visit([&](const auto& voxels) { fill(voxels, rangeOf(grid), grid.dims(), 0, progress, known); });
}

BoxBounds::BoxBounds(const BoxBounds& before, const Grid& grid, const MinMaxBlocks& blocks,
                     std::span<const std::uint8_t> changed, base::Progress& progress)
    : BoxBounds(grid.dims()) {
  assert(changed.size() == blocks.count() && grid.missingCount() == 0);
  grid.visit([&](const auto& voxels) {
    fill(voxels, rangeOf(grid), grid.dims(), 0, progress, &blocks, &before, changed);
  });
}

BoxBounds BoxBounds::ofCubic(const Grid& grid, const Coefficients* coefficients, base::Progress& progress) {
  BoxBounds result(grid.dims());
  const Range range = coefficients ? Range{coefficients->least, coefficients->most} : rangeOf(grid);
  visitSpline(grid, coefficients,
              [&](const auto& samples) { result.fill(samples, range, grid.dims(), 1, progress); });
  return result;
}

BoxBounds BoxBounds::ofPart(const VoxelArray& voxels, glm::ivec3 dims, const Grid& whole,
                            base::Progress& progress) {
  BoxBounds result(dims);
  const Range range = rangeOf(whole);
  std::visit([&](const auto& part) { result.fill(part, range, dims, 0, progress); }, voxels);
  return result;
}

template <class T>
void BoxBounds::fill(const std::vector<T>& voxels, const Range& range, glm::ivec3 voxelDims, int apron,
                     base::Progress& progress, const MinMaxBlocks* known, const BoxBounds* before,
                     std::span<const std::uint8_t> changed) {
  place(known, progress);
  origin_ = static_cast<double>(range.low);
  const double extent = static_cast<double>(range.high) - origin_;
  if (!(extent > 0.0)) {  // constant or missing: nothing can be crossed
    origin_ = 0.0;
    for (Bounds& bounds : bounds_) {
      std::fill(std::begin(bounds.low), std::end(bounds.low), std::uint16_t{1});
      std::fill(std::begin(bounds.high), std::end(bounds.high), std::uint16_t{0});
    }
    return;
  }
  scale_ = kSteps / extent;
  // Each step of it is monotone, rounded or not: of an isovalue within bounds, too, it lies within theirs.
  const auto quantised = [&](float v, bool up) {
    const double q = (static_cast<double>(v) - origin_) * scale_;
    return static_cast<std::uint16_t>(std::clamp(up ? std::ceil(q) : std::floor(q), 0.0, kSteps));
  };
  const Extent3 blocks{dims_};
  const bool sameSteps = before && before->origin_ == origin_ && before->scale_ == scale_;
  parallelSteps(blocks.rows(), progress, {}, [&](std::size_t row) {
    glm::ivec3 block = blocks.firstOfRow(row);
    for (; block.x < dims_.x; ++block.x) {
      const std::size_t index = blocks.index(block);
      const std::uint32_t place = places_[index];
      if (place == kNoPlace) continue;
      if (sameSteps && changed[index] == 0) {
        bounds_[place] = before->bounds_[before->places_[index]];
        continue;
      }
      const auto boxes = BlockScan<T>(voxels, voxelDims, block * kBlockCells, apron).boxes();
      Bounds& bounds = bounds_[place];
      for (int i = 0; i < kBoxesPerBlock; ++i) {
        const Range& box = boxes[static_cast<std::size_t>(i)];
        bounds.low[i] = quantised(box.low, false);
        bounds.high[i] = quantised(box.high, true);
      }
    }
  });
}

void BoxBounds::masks(std::span<const float> storedIsovalues, const std::vector<std::uint8_t>& flags,
                      std::vector<std::uint64_t>& result) const {
  assert(flags.size() == places_.size());
  struct Level {
    std::uint16_t floor, ceiling;
  };
  std::vector<Level> levels;
  for (const float stored : storedIsovalues) {
    const double q = (static_cast<double>(stored) - origin_) * scale_;
    if (!(q >= 0.0 && q < kSteps + 0.5)) continue;  // rounding may put the greatest value above
    const double within = std::min(q, kSteps);
    levels.push_back(
        {static_cast<std::uint16_t>(std::floor(within)), static_cast<std::uint16_t>(std::ceil(within))});
  }
  result.resize(places_.size());
  parallelRanges(places_.size(), 512, [&](const Indices<std::size_t>& range) {
    for (std::size_t block = range.begin(); block < range.end(); ++block) {
      result[block] = 0;
      if (!flags[block] || places_[block] == kNoPlace) continue;
      const Bounds& bounds = bounds_[places_[block]];
      for (const Level level : levels)
        for (int i = 0; i < kBoxesPerBlock; ++i)
          result[block] |=
              static_cast<std::uint64_t>(bounds.low[i] <= level.floor && bounds.high[i] >= level.ceiling)
              << i;
    }
  });
}

}  // namespace isolux::volume
