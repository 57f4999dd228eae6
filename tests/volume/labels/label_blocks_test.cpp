// Labels are counted as a plain loop counts them, and each block lists its own.
#include "volume/labels/label_blocks.h"

#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/common.hpp>

#include "base/error.h"
#include "base/random.h"
#include "tests/support/volumes.h"

namespace isolux::test {
namespace {

using testing::HasSubstr;
using volume::Grid;
using volume::LabelBlocks;

LabelBlocks blocksOf(Grid grid) {
  base::Progress progress;
  return {std::make_shared<const Grid>(std::move(grid)), "a.nii", progress};
}

// `most` labels at random, in boxes of 3 voxels so that blocks have one, few and many.
template <class T>
Grid boxesOfLabels(glm::ivec3 dims, int least, int most, std::uint64_t seed, double slope = 1.0,
                   double intercept = 0.0) {
  std::vector<T> voxels;
  volume::forEachIn(glm::ivec3(0), dims, [&](glm::ivec3 p) {
    const std::uint64_t box = static_cast<std::uint64_t>(p.x / 12 + 100 * (p.y / 12) + 10000 * (p.z / 3));
    voxels.push_back(static_cast<T>(least + static_cast<int>(base::counterHash(seed, box) %
                                                             static_cast<std::uint64_t>(most - least + 1))));
  });
  return {unitGeometry(dims), std::move(voxels), slope, intercept};
}

void expectCounted(const Grid& grid) {
  std::map<int, std::size_t> counts;
  std::map<std::size_t, std::set<int>> ofBlock;
  const LabelBlocks blocks = blocksOf(grid);
  volume::forEachIn(glm::ivec3(0), grid.dims(), [&](glm::ivec3 p) {
    const double value = grid.value(p);
    const int label = std::isnan(value) ? std::numeric_limits<int>::min() : static_cast<int>(value);
    if (!std::isnan(value)) ++counts[label];
    ofBlock[blocks.blocks().index(p / 8)].insert(label);
  });
  ASSERT_EQ(blocks.list().size(), counts.size());
  auto count = counts.begin();
  for (const volume::LabelExtent& label : blocks.list()) {
    EXPECT_EQ(label.label, count->first);
    EXPECT_EQ(label.voxels, count->second);
    EXPECT_EQ(grid.valueOfStored(static_cast<double>(label.stored)), static_cast<double>(label.label));
    ++count;
  }
  std::map<int, std::pair<glm::ivec3, glm::ivec3>> bounds;
  for (const auto& [block, labels] : ofBlock) {
    std::set<int> listed;
    for (const std::uint16_t index : blocks.of(block))
      listed.insert(index == LabelBlocks::kMissing ? std::numeric_limits<int>::min()
                                                   : blocks.list()[index].label);
    EXPECT_EQ(listed, labels) << "block " << block;
    EXPECT_EQ(blocks.of(block).size(), labels.size());
    const glm::ivec3 low = 8 * blocks.blocks().at(block), high = glm::min(low + 8, grid.dims()) - 1;
    for (const int label : labels) {
      const auto [found, isNew] = bounds.try_emplace(label, low, high);
      found->second = {glm::min(found->second.first, low), glm::max(found->second.second, high)};
    }
  }
  for (const volume::LabelExtent& label : blocks.list()) {
    EXPECT_EQ(label.low, bounds.at(label.label).first);
    EXPECT_EQ(label.high, bounds.at(label.label).second);
  }
}

TEST(LabelBlocksTest, CountsEveryStoredType) {
  expectCounted(boxesOfLabels<std::uint8_t>({40, 33, 17}, 0, 5, 1));
  expectCounted(boxesOfLabels<std::int8_t>({17, 8, 24}, -3, 5, 2));
  expectCounted(boxesOfLabels<std::uint16_t>({40, 33, 17}, 0, 40000, 3));
  expectCounted(boxesOfLabels<std::int16_t>({33, 9, 20}, -200, 14175, 4));
  expectCounted(boxesOfLabels<float>({20, 20, 20}, -70000, 70000, 5));
}

TEST(LabelBlocksTest, CountsVolumesThinnerThanABlock) {
  expectCounted(boxesOfLabels<std::uint8_t>({1, 1, 1}, 0, 5, 6));
  expectCounted(boxesOfLabels<std::uint8_t>({100, 1, 3}, 0, 5, 7));
}

TEST(LabelBlocksTest, LabelsAreValuesNotStoredNumbers) {
  expectCounted(boxesOfLabels<std::uint8_t>({20, 10, 10}, 0, 5, 8, 2.0, -3.0));
  expectCounted(boxesOfLabels<std::int16_t>({20, 10, 10}, 0, 5, 8, -1.0, 7.0));
}

TEST(LabelBlocksTest, MissingVoxelsHaveNoLabel) {
  std::vector<float> voxels(16 * 16 * 16, 3.0f);
  voxels[5] = std::numeric_limits<float>::quiet_NaN();
  voxels[4095] = std::numeric_limits<float>::infinity();
  voxels[77] = -0.0f;
  expectCounted({unitGeometry(glm::ivec3(16)), std::move(voxels)});
}

TEST(LabelBlocksTest, FourThousandLabelsInOneBlockRow) {
  std::vector<std::uint16_t> voxels(64 * 8 * 8);
  for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = static_cast<std::uint16_t>(i);
  expectCounted({unitGeometry({64, 8, 8}), std::move(voxels)});
}

std::string refusalOf(Grid grid) {
  try {
    blocksOf(std::move(grid));
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::input);
    EXPECT_EQ(error.file(), "a.nii");
    return error.reason();
  }
  return "accepted";
}

TEST(LabelBlocksTest, RefusesValuesThatAreNoLabels) {
  const auto withVoxel = [](float value) {
    std::vector<float> voxels(27, 1.0f);
    voxels[13] = value;
    return Grid(unitGeometry(glm::ivec3(3)), std::move(voxels));
  };
  EXPECT_THAT(refusalOf(withVoxel(2.5f)), HasSubstr("2.5 is not a whole number"));
  EXPECT_THAT(refusalOf(withVoxel(3e9f)), HasSubstr("too large"));
  EXPECT_EQ(refusalOf(withVoxel(-2147483520.0f)), "accepted");
  std::vector<float> all(65536 + 8);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<float>(i);
  EXPECT_THAT(refusalOf({unitGeometry({static_cast<int>(all.size()), 1, 1}), std::move(all)}),
              HasSubstr("more than 65535"));
}

}  // namespace
}  // namespace isolux::test
