#include "tests/support/sampled_hit.h"
#include "tests/support/volumes.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/rays.h"
#include "volume/field/reconstruct.h"

namespace isolux::volume {
namespace {

struct Subject {
  Subject(const std::string& name, int size)
      : grid(test::phantomGrid(name, size)), blocks(grid, 8, progress) {}
  base::Progress progress;
  Grid grid;
  MinMaxBlocks blocks;
};

struct SampledTally {
  int hits = 0, missed = 0, invented = 0;
  double rmsVoxels = 0.0;
};

// Against exact hits. A sampled hit more than a step behind the exact one has missed it.
SampledTally compare(const Subject& subject, const SampledOptions& options, std::uint64_t rays) {
  SampledTally tally;
  int matched = 0;
  for (std::uint64_t i = 0; i < rays; ++i) {
    const Ray ray = test::randomRay(i, subject.grid.dims());
    const auto exact = firstHit(subject.grid, subject.blocks, 0.0, ray);
    const auto sampled = firstHitSampled(subject.grid, subject.blocks, 0.0, ray, options);
    tally.hits += exact ? 1 : 0;
    if (!sampled) {
      tally.missed += exact ? 1 : 0;
      continue;
    }
    EXPECT_NEAR(std::abs(sampleTrilinear(subject.grid, sampled->voxel).value), sampled->valueError, 1e-12);
    const double behind = exact ? (sampled->t - exact->t) * glm::length(ray.direction) : -1e9;
    // Between the samples before and behind a hit there is a crossing, but rays that run in the surface
    // itself are rounding.
    if (behind < -1.0 / options.rate && i % 8 != 4 && i % 8 != 7) ++tally.invented;
    if (std::abs(behind) > 1.0 / options.rate) {
      ++tally.missed;
      continue;
    }
    tally.rmsVoxels += behind * behind;
    ++matched;
  }
  tally.rmsVoxels = std::sqrt(tally.rmsVoxels / matched);
  return tally;
}

TEST(FirstHitSampled, MissesFewerThinSheetsTheDenserItSamples) {
  const Subject sheet("sheet", 32);  // 0.3 voxels thick
  std::vector<int> missed;
  for (const double rate : {0.5, 1.0, 2.0, 4.0, 8.0}) {
    const SampledTally tally = compare(sheet, {rate, 8.0, 0.0, 8}, 4000);
    EXPECT_EQ(tally.invented, 0) << rate;
    EXPECT_GT(tally.hits, 1500);
    missed.push_back(tally.missed);
  }
  EXPECT_GT(missed[0], missed[1]);
  EXPECT_GT(missed[1], missed[2]);
  EXPECT_GT(missed[2], 0);
  // Steps shorter than the sheet is thick.
  EXPECT_EQ(missed[3], 0);
  EXPECT_EQ(missed[4], 0);
  // Near the isovalue, within one voxel of the sheet, the eight-fold rate is as good as everywhere.
  EXPECT_LT(compare(sheet, {1.0, 8.0, 1.5, 8}, 4000).missed, missed[1] / 2);
}

TEST(FirstHitSampled, RefinementComesNearTheExactHit) {
  const Subject gyroid("gyroid", 48);
  double before = 1.0;
  for (const int refinements : {0, 1, 2, 4, 8}) {
    const SampledTally tally = compare(gyroid, {4.0, 1.0, 0.0, refinements}, 4000);
    EXPECT_EQ(tally.invented, 0);
    EXPECT_LT(tally.missed, tally.hits / 50);
    EXPECT_LT(tally.rmsVoxels, before);
    before = tally.rmsVoxels;
  }
  EXPECT_LT(before, 1e-3);
}

TEST(FirstHitSampled, MissingVoxelsAndOddRaysHaveNoHit) {
  const Subject ball("ball", 16);
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const Ray& ray :
       {Ray{{8, 8, -20}, {0, 0, 0}}, Ray{{8, 8, -20}, {0, 0, nan}}, Ray{{8, 8, -20}, {0, 0, infinity}},
        Ray{{8, 8, -20}, {0, 0, -1}}, Ray{{8, 8, -20}, {0, 0, 1}, 5.0, 1.0}})
    EXPECT_FALSE(firstHitSampled(ball.grid, ball.blocks, 0.0, ray, {}));
  EXPECT_TRUE(firstHitSampled(ball.grid, ball.blocks, 0.0, {{8, 8, -20}, {0, 0, 1}}, {}));
  // A slab 0 0 0 ? 1 1 1: its edge is missing.
  std::vector<float> voxels;
  for (int i = 0; i < 4; ++i)
    for (const float v : {0.0f, 0.0f, 0.0f, std::numeric_limits<float>::quiet_NaN(), 1.0f, 1.0f, 1.0f})
      voxels.push_back(v);
  const Grid slab(GridGeometry::make({7, 2, 2}, glm::dvec3(1)), voxels);
  base::Progress progress;
  EXPECT_FALSE(firstHitSampled(slab, MinMaxBlocks(slab, 8, progress), 0.5, {{-1, 0.5, 0.5}, {1, 0, 0}}, {}));
}

// Both ends of the bracket are known, a sample between them is not: 0 0 0 ? 1 1 1 along x, rays slanted so
// that they step over the gap.
TEST(FirstHitSampled, ABracketWithAGapInItIsRefused) {
  constexpr int n = 12;
  std::vector<float> voxels;
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x)
        voxels.push_back(x == 6 && y % 4 == 0 && z % 4 == 0 ? std::numeric_limits<float>::quiet_NaN()
                         : x < 6                            ? 0.0f
                                                            : 1.0f);
  const Grid grid(GridGeometry::make({n, n, n}, glm::dvec3(1)), voxels);
  base::Progress progress;
  const MinMaxBlocks blocks(grid, 8, progress);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Ray ray{{-1.0, 0.01 * (i % 1000), 0.011 * ((i * 7) % 1000)}, {1.0, 0.02, i % 2 ? 0.03 : -0.01}};
    for (const double rate : {0.15, 0.3, 1.0}) {
      const auto hit = firstHitSampled(grid, blocks, 0.5, ray, {rate, 1.0, 0.0, 6});
      if (!hit) continue;
      ++hits;
      ASSERT_TRUE(std::isfinite(hit->t) && std::isfinite(hit->valueError)) << i;
    }
  }
  EXPECT_GT(hits, 0);  // where the bracket is whole
}

}  // namespace
}  // namespace isolux::volume
