// Tiles among ranks: each finished once whatever ranks do, and nobody is waited for.
#include "app/cluster/tile_queue.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isolux::app {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::uint32_t> numbers(std::uint32_t count) {
  std::vector<std::uint32_t> tiles(count);
  std::iota(tiles.begin(), tiles.end(), 0u);
  return tiles;
}

TEST(TileQueue, ChunksAreSharesOfWhatIsLeftAndThenSingleTiles) {
  TileQueue queue(numbers(40), 2);
  EXPECT_EQ(queue.take(0).size(), 10u);  // 40 / (2 * 2)
  EXPECT_EQ(queue.take(1).size(), 7u);   // 30 / 4
  std::size_t given = 17;
  std::size_t before = 7;
  while (queue.anyLeft()) {
    const std::size_t chunk = queue.take(0).size();
    EXPECT_LE(chunk, before);
    EXPECT_GE(chunk, 1u);
    before = chunk;
    given += chunk;
  }
  EXPECT_EQ(given, 40u);
  EXPECT_EQ(before, 1u);
  TileQueue large(numbers(100000), 1);
  EXPECT_EQ(large.take(0).size(), TileQueue::kMostOfChunk);
}

TEST(TileQueue, TheOldestUnfinishedTileIsGivenASecondTime) {
  TileQueue queue({3, 5, 9}, 3);
  ASSERT_THAT(queue.take(0), ElementsAre(3));
  ASSERT_THAT(queue.take(1), ElementsAre(5));
  ASSERT_THAT(queue.take(1), ElementsAre(9));
  EXPECT_THAT(queue.take(2), ElementsAre(3));
  EXPECT_THAT(queue.take(2), ElementsAre(5));
  EXPECT_THAT(queue.take(0), ElementsAre(9)) << "3 and 5 have two holders, 9 has one";
  EXPECT_THAT(queue.holders(3), ElementsAre(0, 2));
  EXPECT_TRUE(queue.finish(3, 2));
  EXPECT_FALSE(queue.finish(3, 0)) << "the first answer counts";
  EXPECT_EQ(queue.finisher(3), 2);
  EXPECT_THAT(queue.take(2), ElementsAre(9));
  EXPECT_THAT(queue.take(2), IsEmpty()) << "it has had all that is left";
  EXPECT_FALSE(queue.finished());
  EXPECT_TRUE(queue.finish(5, 1));
  EXPECT_TRUE(queue.finish(9, 0));
  EXPECT_TRUE(queue.finished());
  EXPECT_EQ(queue.finishedTiles(), 3u);
}

TEST(TileQueue, NoTilesAreFinishedAtOnce) {
  TileQueue queue({}, 2);
  EXPECT_TRUE(queue.finished());
  EXPECT_THAT(queue.take(1), IsEmpty());
}

// Ranks of any speed, of which all but one stand still at a random moment.
TEST(TileQueue, EachTileIsFinishedOnceWhoeverStandsStill) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    const int ranks = 1 + static_cast<int>(random() % 6);
    const auto count = static_cast<std::uint32_t>(random() % 200);
    TileQueue queue(numbers(count), ranks);
    std::vector<std::vector<std::uint32_t>> hands(static_cast<std::size_t>(ranks));
    std::set<int> still;
    std::vector<int> firsts(count, 0);
    for (int step = 0; !queue.finished(); ++step) {
      ASSERT_LT(step, 100000);
      const int rank = static_cast<int>(random() % static_cast<unsigned>(ranks));
      if (rank > 0 && random() % 100 == 0) still.insert(rank);
      if (still.contains(rank)) continue;
      auto& hand = hands[static_cast<std::size_t>(rank)];
      if (hand.empty()) hand = queue.take(rank);
      if (hand.empty()) continue;
      const std::uint32_t tile = hand.back();
      hand.pop_back();
      firsts[tile] += queue.finish(tile, rank) ? 1 : 0;
    }
    EXPECT_TRUE(std::all_of(firsts.begin(), firsts.end(), [](int n) { return n == 1; })) << seed;
  }
}

}  // namespace
}  // namespace isolux::app
