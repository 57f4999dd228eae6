// Boxes against a brute-force scan of their cells.
#include "volume/skip/box_bounds.h"

#include <cmath>
#include <iterator>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/invalid_operations.h"
#include "volume/field/reconstruct.h"
#include "volume/skip/min_max_blocks.h"

namespace isolux::volume {
namespace {

// With every block looked at.
BoxBounds boundsOf(const Grid& grid, base::Progress& progress) {
  return BoxBounds::ofPart(grid.voxels(), grid.dims(), grid, progress);
}

Grid randomGrid(glm::ivec3 dims, std::mt19937& random, bool gaps) {
  std::vector<float> voxels(GridGeometry::make(dims, glm::dvec3(1.0)).voxelCount());
  std::uniform_real_distribution<float> value(-1.0f, 1.0f);
  float level = 0.0f;
  for (float& v : voxels) {
    level = 0.9f * level + 0.1f * value(random);  // neighbours along x are alike: boxes of both kinds
    v = gaps && random() % 200 == 0 ? std::nanf("") : level;
  }
  return {GridGeometry::make(dims, glm::dvec3(1.0)), voxels};
}

// The cell has voxels on both sides, or one of them is missing.
bool crossed(const Grid& grid, glm::ivec3 cell, float isovalue, int apron) {
  bool below = false, above = false, missing = false;
  for (int z = -apron; z <= 1 + apron; ++z)
    for (int y = -apron; y <= 1 + apron; ++y)
      for (int x = -apron; x <= 1 + apron; ++x) {
        const glm::ivec3 p = glm::clamp(cell + glm::ivec3(x, y, z), glm::ivec3(0), grid.dims() - 1);
        const double v = grid.stored(p.x, p.y, p.z);
        below = below || v < static_cast<double>(isovalue);
        above = above || v >= static_cast<double>(isovalue);
        missing = missing || std::isnan(v);
      }
  return missing || (below && above);
}

TEST(BoxBoundsTest, NoBoxWithACrossingIsLeftOutAndFewOthersAreKept) {
  std::mt19937 random(7);
  for (const glm::ivec3& dims : {glm::ivec3(30, 17, 21), glm::ivec3(9, 9, 9), glm::ivec3(2, 33, 3)})
    for (const bool gaps : {false, true})
      for (const int apron : {0, 1}) {
        const Grid grid = randomGrid(dims, random, gaps);
        base::Progress progress;
        const MinMaxBlocks blocks =
            apron ? MinMaxBlocks::ofCubic(grid, nullptr, 8, progress) : MinMaxBlocks(grid, 8, progress);
        const BoxBounds boxes =
            apron ? BoxBounds::ofCubic(grid, nullptr, progress) : boundsOf(grid, progress);
        ASSERT_EQ(boxes.blockDims(), blocks.dims());
        for (const float isovalue : {0.0f, 0.05f, -0.2f, 0.4f}) {
          std::vector<std::uint8_t> flags;
          blocks.activeBlocks(isovalue, flags);
          std::vector<std::uint64_t> masks;
          const float isovalues[] = {isovalue};
          boxes.masks(isovalues, flags, masks);
          int kept = 0, wanted = 0;
          for (int z = 0; z < dims.z - 1; z += 2)
            for (int y = 0; y < dims.y - 1; y += 2)
              for (int x = 0; x < dims.x - 1; x += 2) {
                const std::size_t block = blocks.index(glm::ivec3(x, y, z) / 8);
                const int bit = x / 2 % 4 + 4 * (y / 2 % 4) + 16 * (z / 2 % 4);
                const bool can = (masks[block] >> bit & 1) != 0;
                bool any = false;
                for (int i = 0; i < 8; ++i) {
                  const glm::ivec3 cell(x + (i & 1), y + (i >> 1 & 1), z + (i >> 2));
                  if (cell.x < dims.x - 1 && cell.y < dims.y - 1 && cell.z < dims.z - 1)
                    any = any || crossed(grid, cell, isovalue, apron);
                }
                kept += can;
                wanted += any;
                if (any && flags[block]) {
                  EXPECT_TRUE(can) << x << ' ' << y << ' ' << z;
                }
              }
          EXPECT_LE(kept, wanted + wanted / 20 + 2);
        }
      }
}

TEST(BoxBoundsTest, SeveralIsovaluesAreTheUnion) {
  std::mt19937 random(8);
  const Grid grid = randomGrid({25, 25, 25}, random, false);
  base::Progress progress;
  const BoxBounds boxes = boundsOf(grid, progress);
  const std::vector<std::uint8_t> flags(27, 1);
  std::vector<std::uint64_t> first, second, both;
  const float isovalues[] = {-0.1f, 0.15f};
  boxes.masks(std::span(isovalues, 1), flags, first);
  boxes.masks(std::span(isovalues + 1, 1), flags, second);
  boxes.masks(isovalues, flags, both);
  for (std::size_t i = 0; i < both.size(); ++i) EXPECT_EQ(both[i], first[i] | second[i]);
  EXPECT_NE(first, both);
}

// Bounds are kept in 65536 steps: an isovalue next to a voxel's own, within one step of it, finds the boxes
// on both of its sides.
TEST(BoxBoundsTest, RoundingIsOutward) {
  std::mt19937 random(10);
  const Grid grid = randomGrid({9, 9, 9}, random, false);
  base::Progress progress;
  const BoxBounds boxes = boundsOf(grid, progress);
  const glm::ivec3 corners = grid.dims() - 1;
  for (int z = 0; z < corners.z; ++z)
    for (int y = 0; y < corners.y; ++y)
      for (int x = 0; x < corners.x; ++x) {
        const auto voxel = static_cast<float>(grid.stored(x, y, z));
        for (const float isovalue : {voxel, std::nextafter(voxel, 9.0f), std::nextafter(voxel, -9.0f)}) {
          if (!crossed(grid, {x, y, z}, isovalue, 0)) continue;
          std::vector<std::uint64_t> masks;
          boxes.masks(std::span(&isovalue, 1), {1}, masks);
          EXPECT_TRUE(masks[0] >> (x / 2 + 4 * (y / 2) + 16 * (z / 2)) & 1) << x << ' ' << y << ' ' << z;
        }
      }
}

// Their steps would be infinite, and any value's place among them 0 times that.
TEST(BoxBoundsTest, OfConstantVolumesNothingIsCountedInSteps) {
  const GridGeometry geometry = GridGeometry::make({9, 9, 9}, glm::dvec3(1.0));
  base::Progress progress;
  std::vector<std::uint64_t> masks;
  const float isovalues[] = {4.0f};
  const test::InvalidOperations invalid;
  boundsOf(Grid(geometry, std::vector<float>(729, 4.0f)), progress).masks(isovalues, {1}, masks);
  EXPECT_FALSE(invalid.met());
}

TEST(BoxBoundsTest, ConstantAndOutsideHaveNone) {
  const GridGeometry geometry = GridGeometry::make({9, 9, 9}, glm::dvec3(1.0));
  std::vector<std::uint64_t> masks;
  const float isovalues[] = {4.0f};
  base::Progress progress;
  boundsOf(Grid(geometry, std::vector<float>(729, 4.0f)), progress).masks(isovalues, {1}, masks);
  EXPECT_EQ(masks[0], 0u);
  std::mt19937 random(9);
  boundsOf(randomGrid({9, 9, 9}, random, false), progress).masks(isovalues, {1}, masks);
  EXPECT_EQ(masks[0], 0u);
}

// Blocks that are known to be constant are not looked at, and never active.
TEST(BoxBoundsTest, OfKnownBlocksAreTheSame) {
  std::mt19937 random(4);
  for (const bool missing : {false, true}) {
    std::vector<float> voxels(std::size_t{20} * 20 * 20, 3.0f);
    for (std::size_t i = 0; i < voxels.size() / 2; ++i) voxels[i] = static_cast<float>(random() % 9);
    if (missing) voxels.back() = std::numeric_limits<float>::quiet_NaN();
    const Grid grid(GridGeometry::make(glm::ivec3(20), glm::dvec3(1.0)), voxels);
    base::Progress progress;
    const MinMaxBlocks blocks(grid, BoxBounds::kBlockCells, progress);
    std::vector<std::uint8_t> flags;
    for (const float isovalue : {0.5f, 3.0f, 7.9f}) {
      blocks.activeBlocks(isovalue, flags);
      std::vector<std::uint64_t> seen, expected;
      BoxBounds(grid, blocks, progress).masks(std::span(&isovalue, 1), flags, seen);
      boundsOf(grid, progress).masks(std::span(&isovalue, 1), flags, expected);
      EXPECT_EQ(seen, expected) << isovalue << ' ' << missing;
    }
  }
}

// 65535 / 29 times 29 is more than 65535 in double precision.
TEST(BoxBoundsTest, TheGreatestValueIsWithinTheBounds) {
  const GridGeometry geometry = GridGeometry::make({9, 9, 9}, glm::dvec3(1.0));
  base::Progress progress;
  for (int greatest = 1; greatest <= 255; ++greatest) {
    std::vector<std::uint8_t> voxels(729, 0);
    voxels[0] = static_cast<std::uint8_t>(greatest);
    std::vector<std::uint64_t> masks;
    const auto isovalue = static_cast<float>(greatest);
    boundsOf(Grid(geometry, voxels), progress).masks(std::span(&isovalue, 1), {1}, masks);
    EXPECT_EQ(masks[0], 1u) << greatest;
  }
}

}  // namespace
}  // namespace isolux::volume
