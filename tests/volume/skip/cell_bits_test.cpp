#include "volume/skip/cell_bits.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/common.hpp>

#include "base/random.h"
#include "volume/skip/active_blocks.h"
#include "volume/skip/box_bounds.h"

namespace isolux::volume {
namespace {

// Smooth, with steps and values that are the isovalue itself.
template <class T>
Grid gridOf(glm::ivec3 dims) {
  std::vector<T> voxels;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) {
        const double noise = base::uniformNoise(7, static_cast<std::uint64_t>(voxels.size()));
        const double wave = 60.0 + 50.0 * std::sin(0.35 * x) * std::cos(0.3 * y + 0.2 * z);
        voxels.push_back(static_cast<T>(noise < 0.02 ? 64.0 : wave));
      }
  return {GridGeometry::make(dims, glm::dvec3(1.0)), std::move(voxels)};
}

struct Bits {
  glm::ivec3 groups;
  std::vector<std::uint64_t> masks;
  bool at(glm::ivec3 cell) const {
    const glm::ivec3 group = cell / 4, in = cell % 4;
    const std::uint64_t mask =
        masks[static_cast<std::size_t>((group.z * groups.y + group.y) * groups.x + group.x)];
    return (mask >> (in.x + 4 * in.y + 16 * in.z) & 1) != 0;
  }
};

Bits bitsOf(const Grid& grid, const std::vector<float>& isovalues) {
  base::Progress progress;
  const auto blocks = std::make_shared<MinMaxBlocks>(grid, 8, progress);
  const BoxBounds bounds(grid, *blocks, progress);
  ActiveBlocks active(blocks);
  active.update(isovalues);
  std::vector<std::uint64_t> boxes;
  bounds.masks(isovalues, active.flags(), boxes);
  Bits bits{2 * blocks->dims(), {}};
  cellBits(grid, blocks->dims(), boxes, isovalues, bits.masks);
  return bits;
}

// By the definition: no corner of a cell without a bit lies on, or on the other side of, an isovalue.
template <class T>
void checkAgainstCorners(glm::ivec3 dims, const std::vector<float>& isovalues) {
  const Grid grid = gridOf<T>(dims);
  const Bits bits = bitsOf(grid, isovalues);
  const double margin = (grid.storedMaximum() - grid.storedMinimum()) * 1e-5;
  int set = 0, clear = 0;
  for (int z = 0; z < dims.z - 1; ++z)
    for (int y = 0; y < dims.y - 1; ++y)
      for (int x = 0; x < dims.x - 1; ++x) {
        const glm::ivec3 cell(x, y, z);
        double least = 1e30, most = -1e30;
        for (int corner = 0; corner < 8; ++corner) {
          const double v = grid.stored(x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2));
          least = std::min(least, v);
          most = std::max(most, v);
        }
        bool must = false, may = false;
        for (const float isovalue : isovalues) {
          const auto level = static_cast<double>(isovalue);
          must = must || (least <= level && most >= level);
          may = may || (least <= level + margin && most >= level - margin);
        }
        const bool bit = bits.at(cell);
        ASSERT_TRUE(bit || !must) << x << " " << y << " " << z;
        ASSERT_TRUE(!bit || may) << x << " " << y << " " << z;
        ++(bit ? set : clear);
      }
  EXPECT_GT(set, 100);
  EXPECT_GT(clear, 100);
}

TEST(CellBits, SayWhichCellsHoldBothSides) {
  for (const glm::ivec3& dims : {glm::ivec3(33, 25, 41), glm::ivec3(20, 9, 14), glm::ivec3(8, 34, 17)}) {
    checkAgainstCorners<float>(dims, {64.0f});
    checkAgainstCorners<std::uint8_t>(dims, {64.0f});
    checkAgainstCorners<std::int16_t>(dims, {63.5f, 90.0f});
    checkAgainstCorners<std::uint16_t>(dims, {20.0f, 40.0f, 64.0f, 100.0f});
  }
}

TEST(CellBits, AreNoneBeyondTheVolume) {
  const Bits bits = bitsOf(gridOf<float>({12, 11, 10}), {64.0f});
  for (int z = 0; z < 4 * bits.groups.z; ++z)
    for (int y = 0; y < 4 * bits.groups.y; ++y)
      for (int x = 0; x < 4 * bits.groups.x; ++x)
        ASSERT_FALSE((x >= 11 || y >= 10 || z >= 9) && bits.at({x, y, z}));
}

}  // namespace
}  // namespace isolux::volume
