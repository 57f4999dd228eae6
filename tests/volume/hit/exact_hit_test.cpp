#include "volume/hit/exact_hit.h"
#include "tests/support/volumes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>
#include <glm/geometric.hpp>

#include "base/random.h"
#include "tests/support/analytic_fields.h"
#include "tests/support/invalid_operations.h"
#include "tests/support/rays.h"
#include "tests/support/test_data.h"
#include "tests/support/trilinear_oracle.h"
#include "volume/field/reconstruct.h"
#include "volume/hit/cell_walk.h"
#include "volume/read/reader.h"

namespace isolux::volume {
namespace {

constexpr double kBeyond = std::numeric_limits<double>::infinity();

using test::HitTally;

// Against the independent search, and against itself: the hit lies on the ray and on the surface.
void compare(const test::TrilinearOracle& oracle, const MinMaxBlocks& blocks, double iso, const Ray& ray,
             HitTally& tally) {
  const Grid& grid = oracle.grid();
  const auto hit = firstHit(grid, blocks, iso, ray);
  test::compareHit(oracle, iso, ray, hit, tally);
  if (!hit) return;
  const double scale = std::max({grid.maximum() - grid.minimum(), std::abs(iso)});
  EXPECT_LE(hit->valueError, 1e-9 * scale);
  EXPECT_LT(glm::distance(hit->voxel, ray.origin + hit->t * ray.direction),
            1e-9 * (1.0 + glm::length(ray.origin)));
  EXPECT_NEAR(sampleTrilinear(grid, hit->voxel).value, iso, 1e-9 * scale);
}

HitTally compareRandomRays(const Grid& grid, double iso, std::uint64_t count, int blockCells) {
  base::Progress progress;
  const MinMaxBlocks blocks(grid, blockCells, progress);
  const test::TrilinearOracle oracle(grid);
  HitTally tally;
  for (std::uint64_t i = 0; i < count; ++i)
    compare(oracle, blocks, iso, test::randomRay(i, grid.dims()), tally);
  return tally;
}

long wrongOf(const HitTally& tally) {
  return tally.misses + tally.inventions;
}

TEST(FirstHit, AgreesWithAnIndependentSearchOnNoiseGyroidAndThinSheet) {
  struct Case {
    const char* name;
    glm::ivec3 dims;
    double iso;
    std::uint64_t rays;
    int blockCells;
  };
  const Case cases[] = {{"noise", {20, 17, 26}, 0.0, 30000, 4},  {"noise", {20, 17, 26}, 0.6, 10000, 8},
                        {"gyroid", {33, 33, 33}, 0.0, 30000, 8}, {"gyroid", {41, 60, 35}, 0.7, 10000, 4},
                        {"sheet", {16, 17, 18}, 0.0, 20000, 8},  {"two_balls", {30, 30, 30}, 0.0, 10000, 4}};
  for (const Case& c : cases) {
    const Grid grid = test::phantomGrid(c.name, c.dims);
    const HitTally tally = compareRandomRays(grid, c.iso, c.rays, c.blockCells);
    EXPECT_EQ(wrongOf(tally), 0) << c.name;
    EXPECT_LE(tally.borderline, tally.rays / 200) << c.name;
    EXPECT_GT(tally.hits, tally.rays / 20) << c.name;
    RecordProperty(std::string(c.name) + "_borderline", static_cast<int>(tally.borderline));
  }
}

TEST(FirstHit, AgreesOnWhiteNoiseOfIntegersWhereTheIsovalueIsThatOfManyVoxels) {
  const glm::ivec3 dims(14, 15, 16);
  const GridGeometry geometry = GridGeometry::make(dims, glm::dvec3(1));
  std::vector<std::int8_t> voxels(geometry.voxelCount());
  for (std::size_t i = 0; i < voxels.size(); ++i)
    voxels[i] = static_cast<std::int8_t>(static_cast<int>(base::counterHash(3, i) % 5) - 2);
  const Grid grid(geometry, voxels, 0.5, 1.0);
  for (const double iso : {0.0, 0.5, 1.0, 1.25, 2.0}) {  // minimum, voxel values, between, maximum
    const HitTally tally = compareRandomRays(grid, iso, 8000, 4);
    EXPECT_EQ(wrongOf(tally), 0) << iso;
  }
  EXPECT_EQ(compareRandomRays(grid, -0.1, 500, 8).hits, 0);
  EXPECT_EQ(compareRandomRays(grid, 2.1, 500, 8).hits, 0);
}

TEST(FirstHit, AgreesWhereVoxelsAreMissing) {
  const GridGeometry geometry = GridGeometry::make({18, 18, 18}, glm::dvec3(1));
  std::vector<float> voxels = std::get<std::vector<float>>(test::phantomGrid("noise", geometry).voxels());
  for (std::size_t i = 0; i < voxels.size(); ++i)
    if (base::uniformNoise(9, i) < 0.03) voxels[i] = std::numeric_limits<float>::quiet_NaN();
  const Grid grid(geometry, voxels);
  base::Progress progress;
  const MinMaxBlocks blocks(grid, 4, progress);
  const test::TrilinearOracle oracle(grid);
  HitTally tally;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    // On a plane between a cell with a missing corner and one without, either answer is right: only rays
    // that run inside the cells are compared.
    if (i % 8 > 3) continue;
    compare(oracle, blocks, 0.0, test::randomRay(i, grid.dims()), tally);
  }
  EXPECT_EQ(wrongOf(tally), 0);
  EXPECT_GT(tally.hits, 1000);
}

// Behind a block without a crossing a ray is on its side, unless it may have come through a gap, were it of
// one voxel.
TEST(FirstHit, WhereAVoxelIsMissingTheSideOfABlockIsNotKnown) {
  std::vector<float> voxels(17 * 9 * 9, 2.0f);
  base::Progress progress;
  const GridGeometry geometry = GridGeometry::make({17, 9, 9}, glm::dvec3(1));
  const auto sideOf = [&](double isovalue) {
    const Grid grid(geometry, voxels);
    return sideOfBlock(MinMaxBlocks(grid, 8, progress), {0, 0, 0}, grid, isovalue, nullptr);
  };
  EXPECT_EQ(sideOf(1.0), Side::inside);
  EXPECT_EQ(sideOf(2.0), Side::inside);
  EXPECT_EQ(sideOf(3.0), Side::outside);
  voxels[5] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(sideOf(1.0), Side::unknown);
  EXPECT_EQ(sideOf(2.0), std::nullopt);
  EXPECT_EQ(sideOf(3.0), Side::unknown);
}

TEST(FirstHit, AgreesOnTinyValuesAndSmallOnesOnAHugeOffset) {
  const GridGeometry geometry = GridGeometry::make({16, 16, 16}, glm::dvec3(1));
  const auto smooth = std::get<std::vector<float>>(test::phantomGrid("noise", geometry).voxels());
  std::vector<float> tiny, offset;
  for (const float v : smooth) {
    tiny.push_back(v * 1e-20f);
    offset.push_back(1e6f + 4.0f * v);
  }
  EXPECT_EQ(wrongOf(compareRandomRays(Grid(geometry, tiny), 1e-21, 4000, 4)), 0);
  EXPECT_EQ(wrongOf(compareRandomRays(Grid(geometry, offset), 1e6 + 0.3, 4000, 4)), 0);
}

TEST(FirstHit, RampIsExactFromBothSides) {
  std::vector<float> voxels;
  for (int i = 0; i < 4; ++i)
    for (int x = 0; x < 10; ++x) voxels.push_back(static_cast<float>(2 * x));
  const Grid grid(GridGeometry::make({10, 2, 2}, glm::dvec3(1)), voxels);
  base::Progress progress;
  const MinMaxBlocks blocks(grid, 8, progress);
  const auto forward = firstHit(grid, blocks, 7.0, {{-4, 0.3, 0.7}, {2, 0, 0}});
  ASSERT_TRUE(forward);
  EXPECT_EQ(forward->voxel, glm::dvec3(3.5, 0.3, 0.7));
  EXPECT_EQ(forward->t, 3.75);
  EXPECT_TRUE(forward->entering);
  const auto backward = firstHit(grid, blocks, 7.0, {{9, 0.5, 0.5}, {-1, 0, 0}});
  ASSERT_TRUE(backward);
  EXPECT_EQ(backward->t, 5.5);
  EXPECT_FALSE(backward->entering);
  // The range of t.
  EXPECT_FALSE(firstHit(grid, blocks, 7.0, {{-4, 0.3, 0.7}, {2, 0, 0}, 0.0, 3.7}));
  EXPECT_TRUE(firstHit(grid, blocks, 7.0, {{-4, 0.3, 0.7}, {2, 0, 0}, 3.7, 3.8}));
  EXPECT_FALSE(firstHit(grid, blocks, 7.0, {{-4, 0.3, 0.7}, {2, 0, 0}, 3.8}));
  // At a voxel's value the surface lies on the plane of voxels.
  const auto onPlane = firstHit(grid, blocks, 8.0, {{-4, 1.0, 0.0}, {1, 0, 0}});
  ASSERT_TRUE(onPlane);
  EXPECT_EQ(onPlane->voxel.x, 4.0);
  EXPECT_EQ(onPlane->valueError, 0.0);
}

TEST(FirstHit, LeavingTheSurfaceIsNoHit) {
  std::vector<float> voxels;
  for (int i = 0; i < 4; ++i)
    for (int x = 0; x < 10; ++x) voxels.push_back(static_cast<float>(x));
  const Grid grid(GridGeometry::make({10, 2, 2}, glm::dvec3(1)), voxels);
  base::Progress progress;
  const MinMaxBlocks blocks(grid, 8, progress);
  for (const double iso : {3.0, 4.5})
    for (const double direction : {-1.0, 1.0})
      EXPECT_FALSE(firstHit(grid, blocks, iso, {{iso, 0.5, 0.5}, {direction, 0, 0}}))
          << iso << ' ' << direction;
}

TEST(FirstHit, ConstantVolumesAndThoseWithoutCellsHaveNoSurface) {
  base::Progress progress;
  const Grid constant(GridGeometry::make({9, 9, 9}, glm::dvec3(1)), std::vector<std::uint8_t>(729, 7));
  const MinMaxBlocks blocks(constant, 4, progress);
  for (const double iso : {6.5, 7.0, 7.5, -kBeyond, kBeyond, std::nan("")})
    EXPECT_FALSE(firstHit(constant, blocks, iso, {{-3, 4, 4.5}, {1, 0.1, 0}}));
  const Grid flat(GridGeometry::make({9, 1, 9}, glm::dvec3(1)), std::vector<float>(81, 1.0f));
  const MinMaxBlocks none(flat, 8, progress);
  EXPECT_FALSE(firstHit(flat, none, 1.0, {{-3, 0, 4.5}, {1, 0, 0}}));
}

TEST(FirstHit, APlateauAtTheIsovalueIsEnteredAndATouchedPeakIsNot) {
  // 0 0 5 5 5 0 | 0 0 5 0 0 0 at isovalue 5, the maximum.
  const auto slab = [](std::vector<int> profile) {
    std::vector<std::uint8_t> voxels;
    for (int i = 0; i < 4; ++i)
      for (const int v : profile) voxels.push_back(static_cast<std::uint8_t>(v));
    return Grid(GridGeometry::make({static_cast<int>(profile.size()), 2, 2}, glm::dvec3(1)), voxels);
  };
  base::Progress progress;
  const Grid plateau = slab({0, 0, 5, 5, 5, 0}), peak = slab({0, 0, 5, 0, 0, 0});
  const auto hit = firstHit(plateau, MinMaxBlocks(plateau, 4, progress), 5.0, {{-2, 0.4, 0.6}, {1, 0, 0}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->voxel.x, 2.0);
  EXPECT_TRUE(hit->entering);
  const auto back = firstHit(plateau, MinMaxBlocks(plateau, 4, progress), 5.0, {{9, 0.4, 0.6}, {-1, 0, 0}});
  ASSERT_TRUE(back);
  EXPECT_EQ(back->voxel.x, 4.0);
  EXPECT_FALSE(firstHit(peak, MinMaxBlocks(peak, 4, progress), 5.0, {{-2, 0.4, 0.6}, {1, 0, 0}}));
  // Out of a plateau that fills whole blocks.
  const Grid wide = slab({5, 5, 5, 5, 5, 5, 5, 5, 5, 0, 0});
  const auto out = firstHit(wide, MinMaxBlocks(wide, 4, progress), 5.0, {{-2, 0.4, 0.6}, {1, 0, 0}});
  ASSERT_TRUE(out);
  EXPECT_EQ(out->voxel.x, 8.0);
  EXPECT_FALSE(out->entering);
}

TEST(FirstHit, AnIsovalueThatIsNoNumberIsRefusedBeforeItIsCompared) {
  const Grid grid = test::phantomGrid("ball", 16);
  base::Progress progress;
  const MinMaxBlocks blocks(grid, 8, progress);
  const test::InvalidOperations invalid;
  EXPECT_FALSE(firstHit(grid, blocks, std::nan(""), {{8, 8, -20}, {0, 0, 1}}));
  EXPECT_FALSE(invalid.met());
}

TEST(FirstHit, OddRaysEndWithoutAHit) {
  const Grid grid = test::phantomGrid("ball", 16);
  base::Progress progress;
  const MinMaxBlocks blocks(grid, 8, progress);
  const double nan = std::nan("");
  EXPECT_FALSE(firstHit(grid, blocks, 0.0, {{8, 8, -20}, {0, 0, 0}}));
  EXPECT_FALSE(firstHit(grid, blocks, 0.0, {{8, 8, -20}, {0, 0, nan}}));
  EXPECT_FALSE(firstHit(grid, blocks, 0.0, {{nan, 8, -20}, {0, 0, 1}}));
  for (double at = 0.5; at < 15.0; at += 0.7)  // within the volume, in cells of all kinds
    for (const glm::dvec3& direction : {glm::dvec3(0.0), glm::dvec3(0.0, 0.0, kBeyond), glm::dvec3(nan)})
      EXPECT_FALSE(firstHit(grid, blocks, 0.0, {glm::dvec3(at), direction})) << at << " " << direction.z;
  EXPECT_FALSE(firstHit(grid, blocks, 0.0, {{8, 8, -20}, {0, 0, kBeyond}}));
  EXPECT_FALSE(firstHit(grid, blocks, 0.0, {{8, 8, -20}, {0, 0, -1}}));
  EXPECT_FALSE(firstHit(grid, blocks, 0.0, {{8, 8, -20}, {1e-320, 0, 1}, 5.0, 1.0}));
  EXPECT_FALSE(firstHit(grid, blocks, 0.0, {{100, 8, 8}, {0, 0, 1}}));
  const auto far = firstHit(grid, blocks, 0.0, {{7.5, 7.5, -1e9}, {0, 0, 1}});
  ASSERT_TRUE(far);
  EXPECT_NEAR(far->voxel.z, 7.5 - 0.35 * 15, 0.1);
}

TEST(FirstHit, GrazingRaysOnTheBallFollowTheClosedForm) {
  const GridGeometry geometry = test::isotropicGeometry(48);
  const Grid grid = test::phantomGrid("ball", geometry);
  base::Progress progress;
  const MinMaxBlocks blocks(grid, 8, progress);
  const test::TrilinearOracle oracle(grid);
  HitTally tally;
  const double radius = 0.35 * 47.0;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const glm::dvec3 n = glm::normalize(test::randomVector(i, 1) - 0.5);
    compare(oracle, blocks, 0.0, test::grazingRay(i, glm::dvec3(23.5) + n * radius, n), tally);
  }
  EXPECT_EQ(wrongOf(tally), 0);
}

// Many rays of all kinds and tangents of what they hit. The benchmark `exact` does the same with 10^7.
TEST(FirstHit, MissesNothingInHundredsOfThousandsOfRays) {
  struct Case {
    Grid grid;
    double isovalue;
  };
  std::vector<Case> cases;
  for (const char* name : {"noise", "gyroid", "sheet"}) cases.push_back({test::phantomGrid(name, 64), 0.0});
  base::Progress progress;
  if (const auto data = test::dataFolder(); !data.empty())
    cases.push_back(
        {*readVolume((data / "volumes" / "ct_head_skin_bone.nii.gz").string(), {}, progress).grid, 0.51});
  for (const Case& c : cases) {
    const MinMaxBlocks blocks(c.grid, 8, progress);
    const test::TrilinearOracle oracle(c.grid);
    const HitTally tally = tbb::parallel_deterministic_reduce(
        tbb::blocked_range<std::uint64_t>(0, 40000, 1000), HitTally(),
        [&](const tbb::blocked_range<std::uint64_t>& range, HitTally sum) {
          for (std::uint64_t i = range.begin(); i != range.end(); ++i) {
            const Ray ray = test::randomRay(i, c.grid.dims());
            const auto hit = firstHit(c.grid, blocks, c.isovalue, ray);
            test::compareHit(oracle, c.isovalue, ray, hit, sum);
            const glm::dvec3 g = hit ? sampleTrilinear(c.grid, hit->voxel).gradient : glm::dvec3(0.0);
            if (i % 4 != 0 || !(glm::length(g) > 0.0)) continue;
            const Ray tangent = test::grazingRay(i, hit->voxel, glm::normalize(g));
            test::compareHit(oracle, c.isovalue, tangent, firstHit(c.grid, blocks, c.isovalue, tangent), sum);
          }
          return sum;
        },
        [](HitTally a, const HitTally& b) {
          a.add(b);
          return a;
        });
    EXPECT_EQ(tally.misses, 0);
    EXPECT_EQ(tally.inventions, 0);
    EXPECT_GT(tally.hits, 10000);
    EXPECT_LT(tally.borderline, tally.rays / 200);
    EXPECT_LT(tally.worstVoxels, 1e-6);
  }
}

}  // namespace
}  // namespace isolux::volume
