// Which bricks stay and which make room: no GL.
#include "render/volume/brick_cache.h"

#include <random>
#include <set>

#include <gtest/gtest.h>

#include "render/gl/shader_library.h"

namespace isolux::render {
namespace {

TEST(BrickCacheTest, BricksCoverTheCells) {
  EXPECT_EQ(brickDims({1, 2, 33}), glm::ivec3(1, 1, 1));
  EXPECT_EQ(brickDims({34, 65, 66}), glm::ivec3(2, 2, 3));
}

TEST(BrickCacheTest, TheShaderHoldsTheSameNumbers) {
  const std::string source = shaderSource("field.glsl");
  EXPECT_NE(source.find("brickShift = 5, brickTexels = 33 + 2 * BRICK_APRON"), std::string::npos);
  EXPECT_EQ(1 << 5, brickCells);
  for (const int apron : {cubicApron, quinticApron}) EXPECT_EQ(33 + 2 * apron, brickTexels(apron));
}

TEST(BrickCacheTest, FreeSlotsComeFirstThenTheLeastRecentlyUsed) {
  BrickCache cache(10, 3);
  for (const BrickCache::Brick brick : {4u, 5u, 6u}) {
    const auto round = cache.beginRound();
    const auto placement = cache.place(brick, round);
    ASSERT_TRUE(placement);
    EXPECT_FALSE(placement->evicted);
  }
  EXPECT_EQ(cache.resident(), 3u);
  cache.beginRound();
  cache.use(4);
  const auto placement = cache.place(7, cache.round());
  ASSERT_TRUE(placement);
  EXPECT_EQ(placement->evicted, 5u);
  EXPECT_EQ(cache.slotOf(7), placement->slot);
  EXPECT_FALSE(cache.slotOf(5));
  EXPECT_TRUE(cache.slotOf(4));
}

TEST(BrickCacheTest, WhatIsKeptIsNotReplaced) {
  BrickCache cache(4, 2);
  const auto first = cache.beginRound();
  cache.place(0, first);
  const auto second = cache.beginRound();
  cache.place(1, second);
  EXPECT_FALSE(cache.place(2, first));  // both were used since
  EXPECT_EQ(cache.oldest(), first);
  EXPECT_EQ(cache.place(2, second)->evicted, 0u);
  EXPECT_FALSE(cache.place(3, second));
}

// Against a model: every brick in at most one slot, no two bricks in one, and the victim the one unused for
// longest.
TEST(BrickCacheTest, RandomUseKeepsSlotsAndBricksOneToOne) {
  constexpr std::size_t bricks = 40, slots = 7;
  BrickCache cache(bricks, slots);
  std::mt19937 random(5);
  std::vector<std::uint64_t> lastUse(bricks, 0);
  for (int round = 0; round < 2000; ++round) {
    const auto now = cache.beginRound();
    const auto brick = static_cast<BrickCache::Brick>(random() % bricks);
    if (cache.slotOf(brick)) {
      cache.use(brick);
    } else {
      const auto placement = cache.place(brick, now);
      ASSERT_TRUE(placement);
      if (placement->evicted)
        for (BrickCache::Brick other = 0; other < bricks; ++other)
          if (cache.slotOf(other) && other != brick) {
            EXPECT_LT(lastUse[*placement->evicted], lastUse[other]);
          }
    }
    lastUse[brick] = now;
    std::set<BrickCache::Slot> taken;
    std::size_t resident = 0;
    for (BrickCache::Brick b = 0; b < bricks; ++b)
      if (const auto slot = cache.slotOf(b)) {
        EXPECT_LT(*slot, slots);
        EXPECT_TRUE(taken.insert(*slot).second);
        ++resident;
      }
    EXPECT_EQ(resident, cache.resident());
  }
}

}  // namespace
}  // namespace isolux::render
