#include "gi/lattice/lattice_part.h"

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/gi/bake/formula_estimator.h"

namespace isolux::gi {
namespace {

std::uint32_t tileAt(const LatticeGeometry& lattice, const LatticeTiles& tiles, glm::ivec3 tile) {
  return tiles.ofBlock.at(lattice.blockOf(tile * (kTileBlocks * kBlockTexels)));
}

TEST(LatticePart, TilesAreNumberedInMortonOrder) {
  const LatticeGeometry cube = LatticeGeometry::make({128, 128, 128}, 1.0);  // 4 x 4 x 4 tiles
  const LatticeTiles tiles = tilesOf(cube);
  EXPECT_EQ(tiles.count, 64u);
  EXPECT_EQ(tileAt(cube, tiles, {0, 0, 0}), 0u);
  EXPECT_EQ(tileAt(cube, tiles, {1, 0, 0}), 1u);
  EXPECT_EQ(tileAt(cube, tiles, {0, 1, 0}), 2u);
  EXPECT_EQ(tileAt(cube, tiles, {0, 0, 1}), 4u);
  EXPECT_EQ(tileAt(cube, tiles, {2, 0, 0}), 8u);
  EXPECT_EQ(tileAt(cube, tiles, {3, 3, 3}), 63u);
  // Where the lattice is no cube of a power of two the numbers have no gaps.
  const LatticeGeometry box = LatticeGeometry::make({70, 40, 36}, 1.0);  // 3 x 2 x 2
  const LatticeTiles some = tilesOf(box);
  EXPECT_EQ(some.count, 12u);
  EXPECT_EQ(std::set<std::uint32_t>(some.ofBlock.begin(), some.ofBlock.end()).size(), 12u);
  EXPECT_EQ(*std::max_element(some.ofBlock.begin(), some.ofBlock.end()), 11u);
  EXPECT_EQ(tileAt(box, some, {2, 0, 0}), 8u);
}

TEST(LatticePart, PartsAreDisjointAndTogetherTheWhole) {
  for (const int count : {1, 2, 3, 5, 12, 20}) {
    const LatticeGeometry lattice = LatticeGeometry::make({70, 40, 36}, 1.0);
    const std::vector<BlockRequest> all = texelsWhere(lattice, [](glm::ivec3) { return true; });
    std::vector<int> times(lattice.blockCount(), 0);
    for (int i = 1; i <= count; ++i)
      for (const BlockRequest& wanted : blocksOfPart(lattice, {i, count}, all)) {
        ++times[wanted.block];
        EXPECT_EQ(wanted.texels, all[wanted.block].texels);
      }
    EXPECT_THAT(times, testing::Each(1)) << count << " parts";
  }
}

}  // namespace
}  // namespace isolux::gi
