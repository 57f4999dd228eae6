#include "gi/lattice/light_lattice.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gi/lattice/texel_bits.h"
#include "tests/support/memory_limit.h"

namespace isolux::gi {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(LatticeGeometry, TexelsLieOnVoxelsAtScaleOne) {
  const LatticeGeometry lattice = LatticeGeometry::make({110, 208, 1}, 1.0);
  EXPECT_EQ(lattice.dims, glm::ivec3(110, 208, 1));
  EXPECT_EQ(lattice.voxelOf({109, 13, 0}), glm::vec3(109.0f, 13.0f, 0.0f));
  EXPECT_EQ(lattice.texelOf({109.0, 13.25, 0.0}), glm::dvec3(109.0, 13.25, 0.0));
  EXPECT_EQ(lattice.voxelsPerTexel(), glm::dvec3(1.0, 1.0, 0.0));
}

TEST(LatticeGeometry, EndsLieOnEndsAtAnyScale) {
  for (const double scale : {0.01, 0.3, 0.5, 1.5, 2.0, 3.7}) {
    const glm::ivec3 voxels(108, 31, 2);
    const LatticeGeometry lattice = LatticeGeometry::make(voxels, scale);
    EXPECT_EQ(lattice.voxelOf({0, 0, 0}), glm::vec3(0.0f));
    for (int a = 0; a < 3; ++a) {
      EXPECT_EQ(lattice.dims[a], static_cast<int>(std::lround((voxels[a] - 1) * scale)) + 1);
      const auto last = static_cast<float>(lattice.dims[a] > 1 ? voxels[a] - 1 : 0);
      EXPECT_EQ(lattice.voxelOf(lattice.dims - 1)[a], last);
    }
    const glm::ivec3 texel = lattice.dims / 2;
    const glm::dvec3 back = lattice.texelOf(glm::dvec3(lattice.voxelOf(texel)));
    for (int a = 0; a < 3; ++a) EXPECT_NEAR(back[a], texel[a], 1e-5 * texel[a]);
  }
}

TEST(LatticeGeometry, BlocksHoldEachTexelOnce) {
  const LatticeGeometry lattice = LatticeGeometry::make({17, 8, 20}, 1.0);
  EXPECT_EQ(lattice.blockDims(), glm::ivec3(3, 1, 3));
  std::vector<int> seen(17 * 8 * 20);
  for (std::uint32_t block = 0; block < lattice.blockCount(); ++block)
    for (int i = 0; i < kTexelsOfBlock; ++i) {
      const glm::ivec3 texel = lattice.texelOf(block, i);
      EXPECT_EQ(texelsWithin(lattice, block)[static_cast<std::size_t>(i)], lattice.contains(texel));
      if (!lattice.contains(texel)) continue;
      EXPECT_EQ(lattice.blockOf(texel), block);
      EXPECT_EQ(LatticeGeometry::indexInBlock(texel), i);
      ++seen[lattice.indexOf(texel)];
    }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), std::ssize(seen));
}

TEST(TexelBits, WordsAreSlices) {
  for (std::size_t i = 0; i < kTexelsOfBlock; ++i) {
    std::bitset<kTexelsOfBlock> one;
    one.set(i);
    TexelWords expected{};
    expected[i / 64] = std::uint64_t{1} << (i % 64);
    EXPECT_EQ(wordsOf(one), expected);
    EXPECT_EQ(bitsOf(expected), one);
    std::vector<std::size_t> visited;
    forEachTexel(one, [&](std::size_t t) { visited.push_back(t); });
    EXPECT_THAT(visited, ElementsAre(i));
  }
}

LatticeBlock blockOf(float value, int lit) {
  LatticeBlock block;
  block.means.assign(kTexelsOfBlock * 3, value);
  std::fill_n(block.samples.begin(), lit, 4u);
  return block;
}

TEST(LightLattice, KeepsWhatIsWritten) {
  LightLattice lattice(LatticeGeometry::make({16, 16, 16}, 1.0), {}, "key");
  EXPECT_FALSE(lattice.at(3));
  const std::size_t empty = lattice.bytes();
  lattice.write(3, blockOf(2.5f, 10));
  lattice.write(5, blockOf(1.5f, 7));
  EXPECT_EQ(lattice.bakedTexels(), 17u);
  EXPECT_GE(lattice.bytes(), empty + 2 * kTexelsOfBlock * 3 * sizeof(float));
  const auto old = lattice.at(3);
  lattice.write(3, blockOf(3.5f, 20));
  ASSERT_TRUE(lattice.at(3));
  EXPECT_EQ(lattice.at(3)->means[0], 3.5f);
  EXPECT_EQ(old->means[0], 2.5f);  // its reader's own
  EXPECT_EQ(lattice.bakedTexels(), 27u);
}

TEST(LightLattice, TellsWhatHasChanged) {
  LightLattice lattice(LatticeGeometry::make({16, 16, 16}, 1.0), {}, "");
  EXPECT_THAT(lattice.changedSince(0), IsEmpty());
  lattice.write(3, blockOf(1.0f, 1));
  lattice.write(5, blockOf(1.0f, 1));
  const std::uint64_t then = lattice.revision();
  EXPECT_THAT(lattice.changedSince(0), ElementsAre(3u, 5u));
  EXPECT_THAT(lattice.changedSince(then), IsEmpty());
  lattice.write(7, blockOf(1.0f, 1));
  lattice.write(3, blockOf(1.0f, 1));
  EXPECT_THAT(lattice.changedSince(then), ElementsAre(7u, 3u));
  EXPECT_THAT(lattice.changedSince(0), ElementsAre(5u, 7u, 3u));
  EXPECT_LT(lattice.clearedAt(), then);

  const std::uint64_t before = lattice.revision();
  lattice.clear();
  EXPECT_GT(lattice.clearedAt(), before);
  EXPECT_EQ(lattice.revision(), lattice.clearedAt());
  EXPECT_THAT(lattice.changedSince(0), IsEmpty());
  EXPECT_EQ(lattice.bakedTexels(), 0u);
  lattice.write(5, blockOf(1.0f, 1));
  EXPECT_THAT(lattice.changedSince(lattice.clearedAt()), ElementsAre(5u));
}

TEST(LightLattice, ReadersSeeWholeBlocks) {
  LightLattice lattice(LatticeGeometry::make({16, 8, 8}, 1.0), {}, "");
  std::atomic<bool> torn{false};
  std::jthread writer([&](const std::stop_token& stop) {
    for (int i = 1; !stop.stop_requested(); ++i)
      lattice.write(static_cast<std::uint32_t>(i % 2), blockOf(static_cast<float>(i), i % kTexelsOfBlock));
  });
  const auto look = [&] {
    std::uint64_t seen = 0;
    for (int i = 0; i < 2000; ++i) {
      const std::uint64_t revision = lattice.revision();
      for (const std::uint32_t changed : lattice.changedSince(seen)) {
        const auto block = lattice.at(changed);
        if (!block) {
          torn = true;
          continue;
        }
        const auto [low, high] = std::minmax_element(block->means.begin(), block->means.end());
        if (*low != *high) torn = true;
      }
      seen = revision;
    }
  };
  std::jthread reader(look);
  look();
  reader.join();
  EXPECT_FALSE(torn);
}

LatticeBlock litBlock(const LightContent& content) {
  LatticeBlock block;
  block.samples.fill(4);
  block.means.assign(static_cast<std::size_t>(kTexelsOfBlock * content.components()), 1.0f);
  return block;
}

TEST(LightLatticeMemory, GrowsAsFarAsTheBudgetAndKeepsWhatIsLit) {
  const LightContent content{LightContent::Kind::irradiance, 3, 0};
  const std::size_t before = base::machineMemory().held();
  {
    LightLattice lattice(LatticeGeometry::make(glm::ivec3(64), 1.0), content, "key");
    const test::MemoryLimit limit(5 * LatticeBlock::bytesOf(content) + 100);
    std::uint32_t lit = 0;
    try {
      for (; lit < lattice.geometry().blockCount(); ++lit) lattice.write(lit, litBlock(content));
      FAIL() << "the budget was not asked";
    } catch (const base::Error& error) {
      EXPECT_EQ(error.kind(), base::ErrorKind::memory);
      EXPECT_THAT(error.reason(), testing::HasSubstr("gi.lattice_scale"));
    }
    EXPECT_EQ(lit, 5u);
    EXPECT_EQ(lattice.bakedTexels(), 5u * kTexelsOfBlock);
    ASSERT_TRUE(lattice.at(2));
    lattice.write(2, LatticeBlock(*lattice.at(2)));  // what is there may become better
    lattice.clear();
    lattice.write(7, litBlock(content));
  }
  EXPECT_EQ(base::machineMemory().held(), before);
}

TEST(LightLatticeMemory, ABlockCountsAsLongAsAnybodyKeepsIt) {
  const LightContent content{LightContent::Kind::irradiance, 1, 0};
  LightLattice lattice(LatticeGeometry::make(glm::ivec3(16), 1.0), content, "key");
  const std::size_t empty = base::machineMemory().held();
  lattice.write(0, litBlock(content));
  const auto kept = lattice.at(0);
  lattice.clear();
  EXPECT_EQ(base::machineMemory().held(), empty + LatticeBlock::bytesOf(content));
}

TEST(LightLatticeMemory, AllOfItIsCheckedBeforeAnythingIsLit) {
  const LightContent content{LightContent::Kind::transfer, 3, 5};
  const LightLattice lattice(LatticeGeometry::make(glm::ivec3(64), 1.0), content, "key");
  EXPECT_EQ(lattice.bytesToFill(), 512 * LatticeBlock::bytesOf(content));
  lattice.checkThatAllFits();
  const std::size_t before = base::machineMemory().held();
  const test::MemoryLimit limit(lattice.bytesToFill() - 1);
  try {
    lattice.checkThatAllFits();
    FAIL() << "the budget was not asked";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::memory);
    EXPECT_THAT(error.reason(), testing::HasSubstr("64 x 64 x 64 texels (transfer of order 5, 3 channels)"));
    EXPECT_THAT(error.reason(), testing::HasSubstr("gi.sh_order"));
  }
  EXPECT_EQ(base::machineMemory().held(), before);
}

}  // namespace
}  // namespace isolux::gi
