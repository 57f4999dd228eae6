#include "volume/skip/min_max_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/random.h"
#include "tests/support/unwatched.h"
#include "volume/field/reconstruct.h"

namespace isolux::volume {
namespace {

template <class T>
Grid randomGrid(glm::ivec3 dims, double missingFraction = 0.0) {
  const GridGeometry geometry = GridGeometry::make(dims, glm::dvec3(1));
  std::vector<T> voxels(geometry.voxelCount());
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const double u = base::uniformNoise(7, i);
    if constexpr (std::is_floating_point_v<T>) {
      voxels[i] = base::uniformNoise(8, i) < missingFraction ? std::numeric_limits<T>::quiet_NaN()
                                                             : static_cast<T>(u - 0.5);
    } else {
      const double low = static_cast<double>(std::numeric_limits<T>::lowest());
      voxels[i] = static_cast<T>(low + u * (static_cast<double>(std::numeric_limits<T>::max()) - low));
    }
  }
  return Grid(geometry, std::move(voxels));
}

// Of blocks, from one value after the other.
class BlockBounds {
 public:
  explicit BlockBounds(std::size_t blocks) : low_(blocks, kInfinity), high_(blocks, -kInfinity) {}
  void add(std::size_t block, double value) {
    if (std::isnan(value)) return;
    low_[block] = std::min(low_[block], static_cast<float>(value));
    high_[block] = std::max(high_[block], static_cast<float>(value));
  }
  void expectOf(const MinMaxBlocks& blocks) const {
    for (std::size_t i = 0; i < blocks.count(); ++i) {
      if (low_[i] > high_[i]) {
        EXPECT_GT(blocks.minimum(i), blocks.maximum(i));
        continue;
      }
      ASSERT_EQ(blocks.minimum(i), low_[i]) << "block " << i;
      ASSERT_EQ(blocks.maximum(i), high_[i]) << "block " << i;
    }
  }

 private:
  static constexpr float kInfinity = std::numeric_limits<float>::infinity();
  std::vector<float> low_, high_;
};

// Each cell on its own, then the block it belongs to.
void compareWithCells(const Grid& grid, int blockCells) {
  base::Progress progress;
  const MinMaxBlocks blocks(grid, blockCells, progress);
  const glm::ivec3 cells = grid.dims() - 1;
  BlockBounds bounds(blocks.count());
  for (int z = 0; z < cells.z; ++z)
    for (int y = 0; y < cells.y; ++y)
      for (int x = 0; x < cells.x; ++x)
        for (int corner = 0; corner < 8; ++corner) {
          const double v = grid.stored(x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2));
          bounds.add(blocks.index(glm::ivec3(x, y, z) / blockCells), v);
        }
  bounds.expectOf(blocks);
}

TEST(MinMaxBlocks, AgreeWithEveryCellForEveryTypeAndOddSizes) {
  for (const int blockCells : {4, 8}) {
    compareWithCells(randomGrid<std::int8_t>({17, 9, 23}), blockCells);
    compareWithCells(randomGrid<std::uint8_t>({16, 8, 8}), blockCells);
    compareWithCells(randomGrid<std::int16_t>({18, 10, 5}), blockCells);
    compareWithCells(randomGrid<std::uint16_t>({2, 33, 9}), blockCells);
    compareWithCells(randomGrid<float>({19, 25, 12}), blockCells);
    compareWithCells(randomGrid<float>({19, 25, 12}, 0.97), blockCells);
  }
}

TEST(MinMaxBlocks, WhereLittleHasChangedTheyAreTheSame) {
  base::Progress progress;
  const glm::ivec3 dims(37, 25, 17);
  const Extent3 voxelBlocks{(dims + kBlockCells - 1) / kBlockCells}, all{dims};
  const Grid before = randomGrid<std::int8_t>(dims);
  const MinMaxBlocks known(before, kBlockCells, progress);
  for (std::size_t block = 0; block < voxelBlocks.count(); ++block) {
    auto voxels = std::get<std::vector<std::int8_t>>(before.voxels());
    const glm::ivec3 low = voxelBlocks.at(block) * kBlockCells, end = glm::min(low + kBlockCells, dims);
    for (int z = low.z; z < end.z; ++z)
      for (int y = low.y; y < end.y; ++y)
        for (int x = low.x; x < end.x; ++x) voxels[all.index(x, y, z)] = 3;
    const Grid after(before.geometry(), voxels);
    std::vector<std::uint8_t> changed(voxelBlocks.count());
    changed[block] = 1;
    const MinMaxBlocks expected(after, kBlockCells, progress),
        found(known, after, cellBlocksIn(changed, dims), progress);
    for (std::size_t i = 0; i < expected.count(); ++i) {
      ASSERT_EQ(found.minimum(i), expected.minimum(i)) << block << ' ' << i;
      ASSERT_EQ(found.maximum(i), expected.maximum(i)) << block << ' ' << i;
    }
  }
}

TEST(MinMaxBlocks, CoverTheVolume) {
  base::Progress progress;
  EXPECT_EQ(MinMaxBlocks(randomGrid<std::uint8_t>({9, 10, 2}), 8, progress).dims(), glm::ivec3(1, 2, 1));
  EXPECT_EQ(MinMaxBlocks(randomGrid<std::uint8_t>({9, 10, 2}), 4, progress).dims(), glm::ivec3(2, 3, 1));
}

TEST(MinMaxBlocks, AnAxisOfOneVoxelHasNoCells) {
  base::Progress progress;
  const MinMaxBlocks blocks(randomGrid<std::uint8_t>({12, 1, 9}), 8, progress);
  EXPECT_EQ(blocks.count(), 0u);
  std::vector<std::uint8_t> flags{1};
  EXPECT_EQ(blocks.activeBlocks(3.0f, flags), 0u);
  EXPECT_TRUE(flags.empty());
}

TEST(MinMaxBlocks, OnlyBlocksThatACrossingCanBeInAreActive) {
  // Two blocks along x: constant 5, then a ramp from 5 to 13.
  std::vector<std::uint8_t> voxels;
  for (int i = 0; i < 4; ++i)
    for (int x = 0; x < 17; ++x) voxels.push_back(static_cast<std::uint8_t>(x <= 8 ? 5 : 5 + x - 8));
  const Grid grid(GridGeometry::make({17, 2, 2}, glm::dvec3(1)), std::move(voxels));
  base::Progress progress;
  const MinMaxBlocks blocks(grid, 8, progress);
  std::vector<std::uint8_t> flags;
  EXPECT_EQ(blocks.activeBlocks(4.9f, flags), 0u);
  EXPECT_EQ(blocks.activeBlocks(5.0f, flags), 1u);
  EXPECT_EQ(flags, (std::vector<std::uint8_t>{0, 1}));
  EXPECT_EQ(blocks.activeBlocks(13.0f, flags), 1u);
  EXPECT_EQ(blocks.activeBlocks(13.1f, flags), 0u);
}

// Every coefficient of every cell, and the field itself at random points of the block.
void compareCubicWithCells(const Grid& grid, const Coefficients* coefficients, int blockCells) {
  base::Progress progress;
  const MinMaxBlocks blocks = MinMaxBlocks::ofCubic(grid, coefficients, blockCells, progress);
  EXPECT_EQ(blocks.dims(), MinMaxBlocks(grid, blockCells, progress).dims());
  const glm::ivec3 last = grid.dims() - 1;
  BlockBounds bounds(blocks.count());
  for (int z = 0; z < last.z; ++z)
    for (int y = 0; y < last.y; ++y)
      for (int x = 0; x < last.x; ++x)
        for (int tap = 0; tap < 64; ++tap) {
          const glm::ivec3 at = glm::clamp(
              glm::ivec3(x, y, z) + glm::ivec3(tap & 3, tap >> 2 & 3, tap >> 4) - 1, glm::ivec3(0), last);
          const double v = coefficients
                               ? static_cast<double>(coefficients->values[grid.index(at.x, at.y, at.z)])
                               : grid.stored(at.x, at.y, at.z);
          bounds.add(blocks.index(glm::ivec3(x, y, z) / blockCells), v);
        }
  bounds.expectOf(blocks);
  for (std::uint64_t i = 0; i < 3000; ++i) {
    const glm::dvec3 p =
        glm::dvec3(base::uniformNoise(4, i), base::uniformNoise(5, i), base::uniformNoise(6, i)) *
        glm::dvec3(last);
    const double value = (coefficients ? sampleCubic(*coefficients, grid, p) : sampleCubic(grid, p)).value;
    if (std::isnan(value)) continue;
    const double stored = grid.storedOfValue(value) - (coefficients ? coefficients->offset : 0.0);
    const std::size_t block = blocks.index(glm::ivec3(p) / blockCells);
    const double low = static_cast<double>(blocks.minimum(block)),
                 high = static_cast<double>(blocks.maximum(block));
    const double rounding = 1e-12 * std::max(std::abs(low), std::abs(high));
    EXPECT_GE(stored, low - rounding);
    EXPECT_LE(stored, high + rounding);
  }
}

TEST(MinMaxBlocks, OfACubicFieldHoldEveryCoefficientAndSoTheField) {
  for (const int blockCells : {4, 8}) {
    compareCubicWithCells(randomGrid<std::uint8_t>({17, 9, 23}), nullptr, blockCells);
    compareCubicWithCells(randomGrid<std::int16_t>({2, 33, 9}), nullptr, blockCells);
    compareCubicWithCells(randomGrid<float>({19, 25, 12}, 0.4), nullptr, blockCells);
    for (const double missing : {0.0, 0.3}) {
      const Grid grid = randomGrid<float>({18, 12, 21}, missing);
      const Coefficients coefficients = interpolatingCoefficients(grid);
      compareCubicWithCells(grid, &coefficients, blockCells);
    }
  }
}

TEST(MinMaxBlocks, StopWhenAsked) {
  base::Progress progress;
  progress.requestStop();
  EXPECT_THROW(MinMaxBlocks(randomGrid<std::uint8_t>({33, 33, 33}), 8, progress), base::Error);
}

}  // namespace
}  // namespace isolux::volume
