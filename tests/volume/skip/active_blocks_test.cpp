#include "volume/skip/active_blocks.h"

#include <algorithm>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "base/random.h"

namespace isolux::volume {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Blocks of many kinds: ramps of different heights over few values (so that bounds are shared by many), whole
// blocks of one value, whole blocks missing.
std::shared_ptr<const MinMaxBlocks> mixedBlocks(glm::ivec3 dims) {
  const GridGeometry geometry = GridGeometry::make(dims, glm::dvec3(1));
  std::vector<float> voxels(geometry.voxelCount());
  std::size_t i = 0;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x, ++i) {
        const auto region = static_cast<std::uint64_t>(x / 6 + 16 * (y / 6) + 256 * (z / 6));
        const std::uint64_t kind = base::counterHash(1, region) % 8;
        const double base = static_cast<double>(base::counterHash(2, region) % 12);
        voxels[i] = kind == 0 ? kNan
                    : kind == 1
                        ? 5.0f
                        : static_cast<float>(base + static_cast<double>(base::counterHash(3, i) % kind));
      }
  base::Progress progress;
  return std::make_shared<MinMaxBlocks>(Grid(geometry, std::move(voxels)), 4, progress);
}

std::vector<std::uint8_t> bruteForce(const MinMaxBlocks& blocks, const std::vector<float>& isovalues) {
  std::vector<std::uint8_t> flags(blocks.count());
  for (std::size_t i = 0; i < blocks.count(); ++i)
    for (const float isovalue : isovalues)
      if (blocks.active(i, isovalue)) flags[i] = 1;
  return flags;
}

// One update against the scan: the flags, their number, and exactly the blocks that differ in the list.
void expectUpdate(ActiveBlocks& active, const std::vector<float>& isovalues) {
  const std::vector<std::uint8_t> before = active.flags();
  const auto changed = active.update(isovalues);
  const std::vector<std::uint8_t> expected = bruteForce(active.blocks(), isovalues);
  ASSERT_EQ(active.flags(), expected);
  EXPECT_EQ(active.activeCount(), static_cast<std::size_t>(std::count(expected.begin(), expected.end(), 1)));
  const std::set<std::uint32_t> unique(changed.begin(), changed.end());
  EXPECT_EQ(unique.size(), changed.size()) << "a block is listed twice";
  for (std::uint32_t i = 0; i < expected.size(); ++i)
    ASSERT_EQ(unique.count(i), before[i] != expected[i] ? 1u : 0u) << "block " << i;
}

// Isovalues as users and data bring them: voxel values, values between, none, outside, infinite.
float someIsovalue(std::uint64_t i) {
  switch (base::counterHash(11, i) % 8) {
    case 0:
      return kNan;
    case 1:
      return -3.0f;
    case 2:
      return 40.0f;
    case 3:
      return base::counterHash(12, i) % 2 ? kInfinity : -kInfinity;
    case 4:
    case 5:
      return static_cast<float>(base::counterHash(13, i) % 19);
    default:
      return static_cast<float>(20.0 * base::uniformNoise(14, i));
  }
}

TEST(ActiveBlocks, FollowTheScanOverRandomSequencesOfIsovalues) {
  for (const std::size_t mostSorted : {10000, 10}) {  // sorted, and not
    ActiveBlocks active(mixedBlocks({50, 41, 33}), mostSorted);
    EXPECT_EQ(active.activeCount(), 0u);
    std::uint64_t counter = 0;
    std::size_t most = 0;
    for (int round = 0; round < 400; ++round) {
      std::vector<float> isovalues(base::counterHash(10, static_cast<std::uint64_t>(round)) % 5);
      for (float& isovalue : isovalues) isovalue = someIsovalue(counter++);
      expectUpdate(active, isovalues);
      most = std::max(most, active.activeCount());
    }
    EXPECT_GT(most, 100u);
  }
}

TEST(ActiveBlocks, FollowASlowDragInBothDirections) {
  ActiveBlocks active(mixedBlocks({50, 41, 33}));
  for (float isovalue = -1.0f; isovalue < 20.0f; isovalue += 0.125f) expectUpdate(active, {isovalue, 6.0f});
  for (float isovalue = 20.0f; isovalue > -1.0f; isovalue -= 0.25f) expectUpdate(active, {6.0f, isovalue});
}

TEST(ActiveBlocks, TheSameIsovaluesInAnotherOrderChangeNothing) {
  for (const std::size_t mostSorted : {10000, 10}) {
    ActiveBlocks active(mixedBlocks({30, 30, 30}), mostSorted);
    EXPECT_FALSE(active.update(std::vector<float>{3.0f, 7.5f}).empty());
    EXPECT_TRUE(active.update(std::vector<float>{7.5f, 3.0f}).empty());
  }
}

TEST(ActiveBlocks, AGridWithoutCellsHasNone) {
  base::Progress progress;
  const Grid flat(GridGeometry::make({9, 1, 9}, glm::dvec3(1)), std::vector<float>(81, 1.0f));
  ActiveBlocks active(std::make_shared<MinMaxBlocks>(flat, 8, progress));
  EXPECT_TRUE(active.update(std::vector<float>{1.0f}).empty());
  EXPECT_TRUE(active.flags().empty());
}

}  // namespace
}  // namespace isolux::volume
