#include "volume/skip/cell_bits.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "volume/parallel/parallel_loops.h"
#include "volume/skip/row_lanes.h"

namespace isolux::volume {

namespace {

constexpr int kCells = 8, kCorners = kCells + 1;  // of a block, along an axis

// Between these a value may lie on either side.
struct Band {
  float low, high;
};

// A bit for each corner of a row: those that may lie below the isovalue, those that may lie above it.
struct Sides {
  unsigned below = 0, above = 0;
  Sides operator|(Sides other) const { return {below | other.below, above | other.above}; }
};

template <class T>
Sides sidesOf(const T* row, Band band) {
  const FourFloats near = fourOf(row), far = fourOf(row + 4);
  Sides sides{eightBits(near <= band.high, far <= band.high), eightBits(near >= band.low, far >= band.low)};
  const auto last = static_cast<float>(row[kCells]);
  sides.below |= static_cast<unsigned>(last <= band.high) << kCells;
  sides.above |= static_cast<unsigned>(last >= band.low) << kCells;
  return sides;
}

// The corners of a row of blocks along x: a row of voxels after the other, as they lie in memory.
template <class T>
class RowOfBlocks {
 public:
  // masks: of its blocks; those that are 0 are left out.
  RowOfBlocks(const std::vector<T>& voxels, glm::ivec3 dims, int blockY, int blockZ,
              std::span<const std::uint64_t> masks)
      : voxels_(voxels), dims_(dims), y_(kCells * blockY), z_(kCells * blockZ), masks_(masks) {
    sides_.resize(masks.size() * kCorners * kCorners);
  }

  void classify(Band band) {
    Sides* sides = sides_.data();
    for (int z = 0; z < kCorners; ++z)
      for (int y = 0; y < kCorners; ++y) {
        const T* const row = voxels_.data() + Extent3{dims_}.index(0, std::min(y_ + y, dims_.y - 1),
                                                                   std::min(z_ + z, dims_.z - 1));
        for (std::size_t block = 0; block < masks_.size(); ++block, ++sides)
          if (masks_[block] != 0) *sides = sidesAt(row, kCells * static_cast<int>(block), band);
      }
  }

  // Adds the cells of a block that hold both sides to the masks of its groups, x fastest.
  void add(std::size_t block, std::uint64_t (&groups)[8]) const {
    const glm::ivec3 first(kCells * static_cast<int>(block), y_, z_);
    const glm::ivec3 cells = glm::min(dims_ - 1 - first, glm::ivec3(kCells));
    const unsigned inside = (1u << cells.x) - 1;
    for (int z = 0; z < cells.z; ++z)
      for (int y = 0; y < cells.y; ++y) {
        const Sides all =
            of(block, y, z) | of(block, y + 1, z) | of(block, y, z + 1) | of(block, y + 1, z + 1);
        const unsigned both = (all.below | all.below >> 1) & (all.above | all.above >> 1) & inside;
        const int group = 2 * (y / 4) + 4 * (z / 4), shift = 4 * (y % 4) + 16 * (z % 4);
        groups[group] |= static_cast<std::uint64_t>(both & 15u) << shift;
        groups[group + 1] |= static_cast<std::uint64_t>(both >> 4) << shift;
      }
  }

 private:
  Sides of(std::size_t block, int y, int z) const {
    return sides_[static_cast<std::size_t>(z * kCorners + y) * masks_.size() + block];
  }
  Sides sidesAt(const T* row, int first, Band band) const {
    if (first + kCells < dims_.x) return sidesOf(row + first, band);
    T copy[kCorners];
    for (int x = 0; x < kCorners; ++x) copy[x] = row[std::min(first + x, dims_.x - 1)];
    return sidesOf(copy, band);
  }

  const std::vector<T>& voxels_;
  glm::ivec3 dims_;
  int y_, z_;
  std::span<const std::uint64_t> masks_;
  std::vector<Sides> sides_;
};

std::vector<Band> bandsOf(const Grid& grid, std::span<const float> storedIsovalues) {
  // Interpolating in single precision is off by some 2^-22 of the range of what is interpolated.
  const auto margin = static_cast<float>(std::ldexp(grid.storedMaximum() - grid.storedMinimum(), -18));
  std::vector<Band> bands;
  for (const float stored : storedIsovalues) bands.push_back({stored - margin, stored + margin});
  return bands;
}

}  // namespace

void cellBits(const Grid& grid, glm::ivec3 blocks, std::span<const std::uint64_t> boxMasks,
              std::span<const float> storedIsovalues, std::vector<std::uint64_t>& result) {
  assert(grid.missingCount() == 0);
  const std::vector<Band> bands = bandsOf(grid, storedIsovalues);
  result.assign(8 * boxMasks.size(), 0);
  const Extent3 extent{blocks}, groupExtent{2 * blocks};
  const auto ofRow = [&](const auto& voxels, std::size_t index) {
    const auto masks = boxMasks.subspan(index * extent.row(), extent.row());
    if (std::all_of(masks.begin(), masks.end(), [](std::uint64_t mask) { return mask == 0; })) return;
    const glm::ivec3 first = extent.firstOfRow(index);
    RowOfBlocks row(voxels, grid.dims(), first.y, first.z, masks);
    for (const Band band : bands) {
      row.classify(band);
      for (std::size_t x = 0; x < masks.size(); ++x) {
        if (masks[x] == 0) continue;
        std::uint64_t groups[8] = {};
        row.add(x, groups);
        const glm::ivec3 block = first + glm::ivec3(static_cast<int>(x), 0, 0);
        for (int i = 0; i < 8; ++i) result[groupExtent.index(2 * block + cornerStep(i))] |= groups[i];
      }
    }
  };
  grid.visit([&](const auto& voxels) {
    parallelRanges(extent.rows(), 4, [&](const Indices<std::size_t>& range) {
      for (std::size_t row = range.begin(); row < range.end(); ++row) ofRow(voxels, row);
    });
  });
}

}  // namespace isolux::volume
