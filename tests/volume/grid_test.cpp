#include "volume/grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <tbb/task_arena.h>
#include <glm/geometric.hpp>

#include "base/progress.h"
#include "base/random.h"
#include "tests/support/analytic_fields.h"

namespace isolux::volume {
namespace {

TEST(GridGeometry, PlacesVoxelsByOriginSpacingAndDirections) {
  const glm::dmat3 directions(glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0));
  const GridGeometry geometry = GridGeometry::make({4, 5, 6}, {0.5, 2.0, 3.0}, {10, 20, 30}, directions);
  EXPECT_EQ(geometry.voxelCount(), 120u);
  EXPECT_EQ(glm::dvec3(geometry.worldFromVoxel * glm::dvec4(1, 1, 1, 1)), glm::dvec3(13.0, 20.5, 32.0));
  EXPECT_EQ(geometry.spacingMm(), glm::dvec3(0.5, 2.0, 3.0));
  EXPECT_EQ(geometry.originMm(), glm::dvec3(10, 20, 30));
  EXPECT_FALSE(geometry.leftHanded());
  const auto [low, high] = geometry.worldBounds();
  EXPECT_EQ(low, glm::dvec3(10, 20, 30));
  EXPECT_EQ(high, glm::dvec3(10 + 5 * 3.0, 20 + 3 * 0.5, 30 + 4 * 2.0));
}

TEST(GridGeometry, InverseUndoesAnObliqueLeftHandedAffine) {
  const GridGeometry geometry = test::obliqueLeftHandedGeometry(16);
  EXPECT_TRUE(geometry.leftHanded());
  const glm::dmat4 inverse = geometry.voxelFromWorld();
  for (const glm::dvec3& voxel : {glm::dvec3(0), glm::dvec3(15, 0, 7.5), glm::dvec3(-3, 40, 2)}) {
    const glm::dvec3 back(inverse * (geometry.worldFromVoxel * glm::dvec4(voxel, 1.0)));
    EXPECT_LT(glm::distance(back, voxel), 1e-12);
  }
  const glm::dmat3 directions = geometry.directions();
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(glm::length(directions[axis]), 1.0, 1e-15);
}

TEST(Grid, ValuesApplySlopeAndInterceptAlsoToTheRange) {
  const Grid grid(GridGeometry::make({2, 2, 1}, glm::dvec3(1)),
                  std::vector<std::int16_t>{-32768, 0, 5, 32767}, -0.5, 10.0);
  EXPECT_EQ(grid.value(0, 0, 0), 16394.0);
  EXPECT_EQ(grid.value(1, 1, 0), -16373.5);
  EXPECT_EQ(grid.minimum(), -16373.5);
  EXPECT_EQ(grid.maximum(), 16394.0);
  EXPECT_EQ(grid.storedOfValue(grid.value(0, 1, 0)), 5.0);
  EXPECT_EQ(grid.bytes(), 8u);
}

TEST(Grid, InfiniteVoxelsAreMissing) {
  constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  const Grid grid(GridGeometry::make({5, 1, 1}, glm::dvec3(1)),
                  std::vector<float>{inf, -inf, nan, 2.0f, -1.0f});
  EXPECT_EQ(grid.missingCount(), 3u);
  EXPECT_TRUE(std::isnan(grid.value(0, 0, 0)));
  EXPECT_EQ(grid.minimum(), -1.0);
  EXPECT_EQ(grid.maximum(), 2.0);
  const Grid empty(GridGeometry::make({2, 1, 1}, glm::dvec3(1)), std::vector<float>{nan, nan});
  EXPECT_EQ(empty.minimum(), 0.0);
  EXPECT_EQ(empty.maximum(), 0.0);
}

TEST(Grid, HashTellsVoxelsGeometryTypeAndScaleApart) {
  const GridGeometry geometry = GridGeometry::make({2, 1, 1}, glm::dvec3(1));
  const Grid grid(geometry, std::vector<std::uint8_t>{1, 2});
  EXPECT_EQ(grid.hash(), Grid(geometry, std::vector<std::uint8_t>{1, 2}).hash());
  EXPECT_NE(grid.hash(), Grid(geometry, std::vector<std::uint8_t>{2, 1}).hash());
  EXPECT_NE(grid.hash(), Grid(geometry, std::vector<std::int8_t>{1, 2}).hash());
  EXPECT_NE(grid.hash(), Grid(geometry, std::vector<std::uint8_t>{1, 2}, 2.0).hash());
  EXPECT_NE(grid.hash(),
            Grid(GridGeometry::make({2, 1, 1}, glm::dvec3(2)), std::vector<std::uint8_t>{1, 2}).hash());
}

// Pieces of 1 MiB are hashed on any core in any order.
TEST(Grid, HashSeesEveryPieceAndItsPlaceAndDoesNotDependOnThreads) {
  const GridGeometry geometry = GridGeometry::make({1024, 1024, 3}, glm::dvec3(1));
  std::vector<std::uint8_t> voxels(geometry.voxelCount());
  for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = static_cast<std::uint8_t>(base::hash64(i));
  const std::uint64_t hash = Grid(geometry, voxels).hash();
  tbb::task_arena alone(1);
  alone.execute([&] { EXPECT_EQ(Grid(geometry, voxels).hash(), hash); });
  std::vector<std::uint8_t> swapped = voxels;
  std::swap_ranges(swapped.begin(), swapped.begin() + (1 << 20), swapped.begin() + (2 << 20));
  EXPECT_NE(Grid(geometry, swapped).hash(), hash);
  for (const std::size_t at : {std::size_t{0}, std::size_t{(1 << 20) - 1}, voxels.size() - 1}) {
    std::vector<std::uint8_t> other = voxels;
    ++other[at];
    EXPECT_NE(Grid(geometry, std::move(other)).hash(), hash);
  }
}

TEST(Grid, RangeAndMissingVoxelsAreThoseOfAllPieces) {
  const GridGeometry geometry = GridGeometry::make({700, 800, 1}, glm::dvec3(1));
  std::vector<float> voxels(700 * 800, 1.0f);
  voxels[0] = -7.0f;
  voxels[300000] = std::numeric_limits<float>::quiet_NaN();
  voxels[400000] = std::numeric_limits<float>::infinity();
  voxels[559999] = 9.0f;
  const Grid grid(geometry, std::move(voxels), -2.0, 1.0);
  EXPECT_EQ(grid.storedMinimum(), -7.0);
  EXPECT_EQ(grid.storedMaximum(), 9.0);
  EXPECT_EQ(grid.minimum(), -17.0);
  EXPECT_EQ(grid.maximum(), 15.0);
  EXPECT_EQ(grid.missingCount(), 2u);
}

TEST(Grid, AStopEndsTheScan) {
  base::Progress progress;
  progress.requestStop();
  const GridGeometry geometry = GridGeometry::make({64, 64, 64}, glm::dvec3(1));
  EXPECT_THROW(Grid(geometry, std::vector<float>(geometry.voxelCount()), 1.0, 0.0, progress), base::Error);
}

}  // namespace
}  // namespace isolux::volume
