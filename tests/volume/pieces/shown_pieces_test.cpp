#include "volume/pieces/shown_pieces.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "tests/support/memory_limit.h"
#include "tests/support/volumes.h"
#include "volume/pieces/piece_seeds.h"
#include "volume/pieces/piece_sets.h"

namespace isolux::volume {
namespace {

// Balls of radii 9, 6 and 3 mm in a left-handed, anisotropic place of the world.
constexpr glm::dvec3 kCentres[] = {{20, 12, 14}, {44, 16, 20}, {60, 24, 10}};
constexpr double kRadii[] = {9.0, 6.0, 3.0};

Grid balls() {
  GridGeometry geometry = GridGeometry::make({70, 36, 30}, {1.0, 1.0, 1.0});
  geometry.worldFromVoxel[0] *= -1.0;
  geometry.worldFromVoxel[3] = {75.0, 0.0, 0.0, 1.0};
  return test::gridOfWorld(geometry, [](glm::dvec3 p) {
    double most = -1e9;
    for (std::size_t i = 0; i < 3; ++i) most = std::max(most, kRadii[i] - glm::length(p - kCentres[i]));
    return most;
  });
}

class ShownPieces : public ::testing::Test {
 protected:
  // Which balls are shown, by their centres: the others' voxels are hidden, and none else.
  std::vector<bool> shownBalls(const scene::Pieces& choice) {
    base::Progress progress;
    const auto pieces = sets.at(0.0, scene::Inside::above, progress);
    EXPECT_EQ(pieces->list().size(), 3u);
    const auto hidden = sets.hidden(choice, 0.0, scene::Inside::above, progress);
    std::vector<bool> shown;
    for (const glm::dvec3& centre : kCentres) shown.push_back(!hidden || !hidden->at(voxelOf(centre)));
    if (hidden) expectNothingElseHidden(*hidden, shown);
    return shown;
  }
  glm::ivec3 voxelOf(glm::dvec3 world) const {
    return glm::ivec3(glm::round(grid->geometry().voxelFromWorld() * glm::dvec4(world, 1.0)));
  }
  void expectNothingElseHidden(const VoxelMask& hidden, const std::vector<bool>& shown) const {
    const glm::ivec3 n = grid->dims();
    for (int z = 0; z < n.z; ++z)
      for (int y = 0; y < n.y; ++y)
        for (int x = 0; x < n.x; ++x) {
          const glm::dvec3 p(grid->geometry().worldFromVoxel * glm::dvec4(x, y, z, 1.0));
          bool expected = false;
          for (std::size_t i = 0; i < 3; ++i)
            expected = expected || (!shown[i] && glm::length(p - kCentres[i]) <= kRadii[i]);
          ASSERT_EQ(hidden.at({x, y, z}), expected) << x << " " << y << " " << z;
        }
  }

  std::shared_ptr<const PreparedVolume> prepared = test::prepared(balls());
  std::shared_ptr<const Grid> grid = prepared->volume.grid;
  const PieceSets& sets = *prepared->pieces;
};

using Shown = std::vector<bool>;

scene::Pieces keep(int largest) {
  return {largest, 0.0, {}, {}};
}

TEST_F(ShownPieces, AllUnlessSomethingIsChosen) {
  base::Progress progress;
  EXPECT_EQ(sets.hidden({}, 0.0, scene::Inside::above, progress), nullptr);
  EXPECT_EQ(sets.find(0.0, scene::Inside::above), nullptr);  // nobody had to know the pieces
  EXPECT_EQ(shownBalls(keep(3)), (Shown{true, true, true}));
}

TEST_F(ShownPieces, TheLargestAreKept) {
  EXPECT_EQ(shownBalls(keep(1)), (Shown{true, false, false}));
  EXPECT_EQ(shownBalls(keep(2)), (Shown{true, true, false}));
}

TEST_F(ShownPieces, SmallOnesAreHidden) {
  EXPECT_EQ(shownBalls({0, 500.0, {}, {}}), (Shown{true, true, false}));  // 3054, 905 and 113 mm^3
  EXPECT_EQ(shownBalls({0, 1000.0, {}, {}}), (Shown{true, false, false}));
}

TEST_F(ShownPieces, PointsNameThePiecesThatHoldThem) {
  EXPECT_EQ(shownBalls({0, 0.0, {kCentres[0] + 5.1}, {}}), (Shown{false, true, true}));
  EXPECT_EQ(shownBalls({0, 0.0, {glm::dvec3(1.0), glm::dvec3(1e6)}, {}}), (Shown{true, true, true}));
  EXPECT_EQ(shownBalls({0, 0.0, {}, {kCentres[1], kCentres[2]}}), (Shown{false, true, true}));
  EXPECT_EQ(shownBalls({0, 0.0, {kCentres[1]}, {kCentres[1], kCentres[2]}}), (Shown{false, false, true}));
  EXPECT_EQ(shownBalls({0, 0.0, {}, {glm::dvec3(1.0)}}), (Shown{false, false, false}));
}

TEST_F(ShownPieces, SeedsAreTheDeepestVoxelsAndNameTheirPieces) {
  base::Progress progress;
  const auto pieces = sets.at(0.0, scene::Inside::above, progress);
  const auto seeds = pieceSeeds(*pieces, progress);
  ASSERT_EQ(seeds.size(), 3u);
  for (std::uint32_t i = 0; i < 3; ++i) {
    EXPECT_EQ(seeds[i], voxelOf(kCentres[i]));
    EXPECT_EQ(seedAbove(*grid, pieces->level(), voxelOf(kCentres[i] + 0.5 * kRadii[i])), seeds[i]);
    const glm::dvec3 point = grid->geometry().worldOf(seeds[i]);
    EXPECT_EQ(pieces->ofPoint(glm::dvec3(grid->geometry().voxelFromWorld() * glm::dvec4(point, 1.0))), i);
  }
}

TEST_F(ShownPieces, AreKeptUntilOthersAreAskedFor) {
  base::Progress progress;
  const auto first = sets.at(0.0, scene::Inside::above, progress);
  EXPECT_EQ(sets.at(0.0, scene::Inside::above, progress), first);
  EXPECT_NE(sets.at(0.0, scene::Inside::below, progress), first);
  EXPECT_EQ(sets.hidden(keep(1), 0.0, scene::Inside::above, progress),
            sets.hidden(keep(1), 0.0, scene::Inside::above, progress));
  for (int i = 1; i < 12; ++i) sets.at(0.1 * i, scene::Inside::above, progress);
  EXPECT_EQ(sets.find(0.0, scene::Inside::above), nullptr);
}

// What is kept of other isovalues goes before pieces are refused.
TEST(PieceSets, ManyIsovaluesAreAskedForInLittleMemory) {
  const glm::ivec3 dims(64);
  std::vector<std::uint8_t> noise(static_cast<std::size_t>(dims.x * dims.y * dims.z));
  for (std::size_t i = 0; i < noise.size(); ++i)
    noise[i] = static_cast<std::uint8_t>(base::hash32(static_cast<std::uint32_t>(i)) >> 24);
  const auto grid = std::make_shared<const Grid>(test::unitGeometry(dims), VoxelArray(std::move(noise)));
  base::Progress progress;
  const PieceSets sets(grid, std::make_shared<const MinMaxBlocks>(*grid, kBlockCells, progress));
  std::size_t one = 0;
  {
    const std::size_t before = base::machineMemory().held();
    const PieceSets first(grid, std::make_shared<const MinMaxBlocks>(*grid, kBlockCells, progress));
    first.at(100.5, scene::Inside::above, progress);
    one = base::machineMemory().held() - before;
  }
  const test::MemoryLimit limit(3 * one);
  for (int i = 0; i < 20; ++i)
    EXPECT_FALSE(sets.at(100.5 + i, scene::Inside::above, progress)->list().empty()) << i;
  EXPECT_TRUE(sets.find(119.5, scene::Inside::above));
  const test::MemoryLimit none(0);
  EXPECT_NO_THROW(sets.at(119.5, scene::Inside::above, progress));
}

TEST_F(ShownPieces, StraysAreHiddenWhereTheShownOnesAreNamed) {
  EXPECT_TRUE(hidesStrays(keep(1)));
  EXPECT_TRUE(hidesStrays({0, 500.0, {}, {}}));
  EXPECT_TRUE(hidesStrays({0, 0.0, {}, {kCentres[1]}}));
  EXPECT_FALSE(hidesStrays({0, 0.0, {kCentres[1]}, {}}));
}

}  // namespace
}  // namespace isolux::volume
