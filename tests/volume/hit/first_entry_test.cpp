#include "tests/support/first_entry.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/random.h"
#include "tests/support/rays.h"
#include "tests/support/trilinear_oracle.h"
#include "tests/support/volumes.h"
#include "volume/field/reconstruct.h"
#include "volume/hit/exact_hit.h"

namespace isolux::volume {
namespace {

using scene::Inside;

Grid gridOf(glm::ivec3 dims, std::vector<float> values, double slope = 1.0) {
  return {GridGeometry::make(dims, glm::dvec3(1)), VoxelArray(std::move(values)), slope, 0.0};
}

Grid noise(glm::ivec3 dims) {
  return test::phantomGrid("noise", dims);
}

// Samples at x of one function along x.
Grid along(const std::vector<float>& samples, double slope = 1.0) {
  const glm::ivec3 dims(static_cast<int>(samples.size()), 3, 3);
  std::vector<float> values;
  for (int i = 0; i < 9; ++i) values.insert(values.end(), samples.begin(), samples.end());
  return gridOf(dims, values, slope);
}

Ray fromLeft(double x, double length = std::numeric_limits<double>::infinity()) {
  return {{x, 1.3, 0.6}, {1, 0, 0}, 0.0, length};
}

TEST(FirstEntry, ARampIsEnteredExactlyAndOnlyUphill) {
  const Grid grid = along({0, 1, 2, 3, 4, 5});
  EXPECT_DOUBLE_EQ(firstEntry(grid, Inside::above, 2.25, fromLeft(0.5)).value(), 1.75);
  EXPECT_FALSE(firstEntry(grid, Inside::above, 2.25, {{4, 1, 1}, {-1, 0, 0}}));
  EXPECT_DOUBLE_EQ(firstEntry(grid, Inside::below, 2.25, {{4, 1, 1}, {-0.5, 0, 0}}).value(), 3.5);
  EXPECT_FALSE(firstEntry(grid, Inside::below, 2.25, fromLeft(0.5)));
  EXPECT_FALSE(firstEntry(grid, Inside::above, 2.25, fromLeft(2.5)));       // begins inside
  EXPECT_FALSE(firstEntry(grid, Inside::above, 2.25, fromLeft(0.5, 1.7)));  // ends before
  EXPECT_TRUE(firstEntry(grid, Inside::above, 2.25, fromLeft(0.5, 1.8)));
}

TEST(FirstEntry, OfANegativeSlopeTheInsideIsInValues) {
  const Grid grid = along({0, 1, 2, 3, 4, 5}, -1.0);  // values fall
  EXPECT_FALSE(firstEntry(grid, Inside::above, 2.25, fromLeft(0.5)));
  EXPECT_DOUBLE_EQ(firstEntry(grid, Inside::below, 2.25, fromLeft(0.5)).value(), 1.75);
}

TEST(FirstEntry, FromInsideARayMustLeaveFirst) {
  const Grid grid = along({2, 0, 2, 0, 2});
  EXPECT_DOUBLE_EQ(firstEntry(grid, Inside::above, 1.0, fromLeft(0.25)).value(), 1.25);
  EXPECT_DOUBLE_EQ(firstEntry(grid, Inside::above, 1.0, fromLeft(0.5)).value(), 1.0);  // on it, f falls
  EXPECT_DOUBLE_EQ(firstEntry(grid, Inside::above, 1.0, fromLeft(1.5)).value(), 2.0);  // on it, f rises
}

TEST(FirstEntry, TouchingIsNoEntryAPlateauIs) {
  EXPECT_FALSE(firstEntry(along({0, 1, 0, 0}), Inside::above, 1.0, fromLeft(0.2)));
  EXPECT_DOUBLE_EQ(firstEntry(along({0, 1, 1, 0}), Inside::above, 1.0, fromLeft(0.25)).value(), 0.75);
  EXPECT_FALSE(firstEntry(along({2, 1, 2}), Inside::above, 1.0, fromLeft(0.2)));
  EXPECT_FALSE(firstEntry(along({1, 1, 1}), Inside::above, 1.0, fromLeft(0.2)));
}

// Trilinear functions of one cell are cubic along a diagonal: x (1-y) z and the like reach two crossings.
TEST(FirstEntry, ExitAndReentryInOneCell) {
  // Along the diagonal of the cell f = (1-s)^3 + s^3: 1 at the ends, 1/4 in the middle.
  std::vector<float> values(8, 0.0f);
  values[0] = values[7] = 1.0f;
  const Grid grid = gridOf({2, 2, 2}, values);
  const Ray diagonal{{0, 0, 0}, {1, 1, 1}};
  const double s = 0.5 + std::sqrt((0.5 - 0.25) / 3.0);  // 1 - 3 s + 3 s^2 = 1/2
  EXPECT_NEAR(firstEntry(grid, Inside::above, 0.5, diagonal).value(), s, 1e-14);
  // The other way round: outside at the ends, inside between.
  EXPECT_NEAR(firstEntry(grid, Inside::below, 0.5, diagonal).value(), 1.0 - s, 1e-14);
}

TEST(FirstEntry, BehindAGapTheSideIsFoundAnew) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(firstEntry(along({0, 0, nan, 2, 2, 2}), Inside::above, 1.0, fromLeft(0.2)));
  EXPECT_DOUBLE_EQ(firstEntry(along({0, 0, nan, 2, 0, 2}), Inside::above, 1.0, fromLeft(0.5)).value(), 4.0);
  EXPECT_DOUBLE_EQ(firstEntry(along({2, 2, nan, 0, 2}), Inside::above, 1.0, fromLeft(0.5)).value(), 3.0);
}

TEST(FirstEntry, WhatIsNotARayOrHasNoCellsHitsNothing) {
  const Grid grid = along({0, 1, 2});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(firstEntry(grid, Inside::above, nan, fromLeft(0.5)));
  EXPECT_FALSE(firstEntry(grid, Inside::above, 1.0, {{nan, 1, 1}, {1, 0, 0}}));
  EXPECT_FALSE(firstEntry(grid, Inside::above, 1.0, {{0.5, 1, 1}, {0, 0, 0}}));
  EXPECT_FALSE(firstEntry(gridOf({1, 3, 3}, std::vector<float>(9)), Inside::above, 0.0, fromLeft(0.0)));
}

// Of rays that begin outside and enter, the entry is the first crossing of any kind: an independent search.
TEST(FirstEntry, IsTheFirstCrossingOfRaysThatBeginOutside) {
  const Grid grid = noise({20, 17, 26});
  const test::TrilinearOracle oracle(grid);
  test::HitTally tally;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    Ray ray = test::randomRay(i, grid.dims());
    const double iso = 0.4;
    const auto any = oracle.firstHit(iso, ray);
    if (!any) {
      EXPECT_FALSE(firstEntry(grid, Inside::above, iso, ray)) << i;
      continue;
    }
    const glm::dvec3 behind = ray.origin + (*any + 1e-6 / glm::length(ray.direction)) * ray.direction;
    if (!(sampleTrilinear(grid, behind).value > iso + 1e-9)) continue;  // leaving, or a touch
    RayHit hit;
    if (const auto t = firstEntry(grid, Inside::above, iso, ray)) {
      hit.t = *t;
      hit.voxel = ray.origin + *t * ray.direction;
      test::compareHit(oracle, iso, ray, hit, tally);
    } else {
      test::compareHit(oracle, iso, ray, std::nullopt, tally);
    }
  }
  EXPECT_EQ(tally.misses + tally.inventions, 0);
  EXPECT_LE(tally.borderline, 40);
  EXPECT_GT(tally.hits, 1000);
}

}  // namespace
}  // namespace isolux::volume
