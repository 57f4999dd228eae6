#include "volume/field/coefficients.h"
#include "tests/support/rays.h"
#include "tests/support/volumes.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/random.h"
#include "tests/support/analytic_fields.h"
#include "tests/support/memory_limit.h"
#include "tests/support/stop_latency.h"
#include "tests/support/unwatched.h"
#include "volume/field/reconstruct.h"
#include "volume/hit/exact_cubic_hit.h"

namespace isolux::volume {
namespace {

using test::gridOfVoxels;
using test::randomPoint;

TEST(Coefficients, PrefilteredSplinePassesThroughAllSamplesAtTheBorderToo) {
  for (const glm::ivec3& dims : {glm::ivec3(17, 9, 12), glm::ivec3(1, 8, 2), glm::ivec3(2, 2, 2),
                                 glm::ivec3(1, 1, 1), glm::ivec3(3, 1, 40)}) {
    const Grid grid = gridOfVoxels(GridGeometry::make(dims, glm::dvec3(1)), [](glm::dvec3 p) {
      return base::uniformNoise(5, static_cast<std::uint64_t>(p.x + 50 * p.y + 2500 * p.z)) * 100.0 - 30.0;
    });
    const Coefficients coefficients = interpolatingCoefficients(grid);
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y)
        for (int x = 0; x < dims.x; ++x)
          ASSERT_NEAR(sampleCubic(coefficients, grid, {x, y, z}).value, grid.value(x, y, z), 1e-3)
              << x << ' ' << y << ' ' << z;
  }
}

TEST(Coefficients, InterpolatingSplineReproducesCubicPolynomialsAwayFromTheBorder) {
  const auto f = [](glm::dvec3 p) {
    const glm::dvec3 q = (p - 20.0) / 10.0;
    return q.x * q.x * q.x - 2.0 * q.y * q.y * q.x + q.z * q.z * q.z * q.y;
  };
  const Grid grid = gridOfVoxels(test::unitGeometry(glm::ivec3(41)), f);
  const Coefficients coefficients = interpolatingCoefficients(grid);
  for (std::uint64_t i = 0; i < 100; ++i) {
    const glm::dvec3 p = randomPoint(i, glm::dvec3(15), glm::dvec3(25));  // the border is damped by |pole|^15
    const FieldSample s = sampleCubic(coefficients, grid, p);
    const test::Derivatives d = test::differences(f, p, 1e-3);
    EXPECT_NEAR(s.value, f(p), 1e-5);
    EXPECT_LT(glm::distance(s.gradient, d.gradient), 1e-5);
    for (int c = 0; c < 3; ++c) EXPECT_LT(glm::distance(s.hessian[c], d.hessian[c]), 1e-4);
  }
}

TEST(Coefficients, MissingVoxelsAreFilledBeforeThePrefilterAndNowhereElse) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Grid grid = gridOfVoxels(test::unitGeometry(glm::ivec3(9)), [nan](glm::dvec3 p) {
    return glm::distance(p, glm::dvec3(4)) < 2.0 ? static_cast<double>(nan) : 5.0;
  });
  EXPECT_GT(grid.missingCount(), 20u);
  const Coefficients coefficients = interpolatingCoefficients(grid);
  for (const float c : coefficients.values)
    EXPECT_NEAR(coefficients.offset + static_cast<double>(c), 5.0, 1e-5);
  EXPECT_TRUE(std::isnan(sampleTrilinear(grid, {4, 4, 4}).value));
  EXPECT_TRUE(std::isnan(sampleCubic(grid, {4, 4, 1.5}).value));
  EXPECT_NEAR(sampleTrilinear(grid, {0.5, 0.5, 0.5}).value, 5.0, 1e-12);
  const Grid none =
      gridOfVoxels(test::unitGeometry(glm::ivec3(3)), [nan](glm::dvec3) { return static_cast<double>(nan); });
  for (const float c : interpolatingCoefficients(none).values) EXPECT_EQ(c, 0.0f);
}

// A gyroid in steps of 1/16, which float32 keeps exactly also beside 1e6: both splines are the same function.
TEST(Coefficients, AGreatOffsetOfTheValuesCostsDerivativesNothing) {
  constexpr double offset = 1e6;
  const auto steps = [](glm::dvec3 p) {
    const glm::dvec3 q = p / 3.0;
    const double f =
        std::sin(q.x) * std::cos(q.y) + std::sin(q.y) * std::cos(q.z) + std::sin(q.z) * std::cos(q.x);
    return std::round(16.0 * f) / 16.0;
  };
  const Grid plain = gridOfVoxels(test::unitGeometry(glm::ivec3(24)), steps);
  const Grid shifted =
      gridOfVoxels(test::unitGeometry(glm::ivec3(24)), [&](glm::dvec3 p) { return offset + steps(p); });
  const Coefficients a = interpolatingCoefficients(plain), b = interpolatingCoefficients(shifted);
  for (std::uint64_t i = 0; i < 300; ++i) {
    const glm::dvec3 p = randomPoint(i, glm::dvec3(0), glm::dvec3(23));
    const FieldSample expected = sampleCubic(a, plain, p), found = sampleCubic(b, shifted, p);
    EXPECT_NEAR(found.value - offset, expected.value, 2e-6);
    EXPECT_LT(glm::distance(found.gradient, expected.gradient), 5e-6);
    for (int c = 0; c < 3; ++c) EXPECT_LT(glm::distance(found.hessian[c], expected.hessian[c]), 2e-5);
  }
  base::Progress progress;
  const MinMaxBlocks blocksA = MinMaxBlocks::ofCubic(plain, &a, 8, progress),
                     blocksB = MinMaxBlocks::ofCubic(shifted, &b, 8, progress);
  int hits = 0;
  for (std::uint64_t i = 0; i < 300; ++i) {
    const Ray ray{{base::uniformNoise(1, i) * 23.0, base::uniformNoise(2, i) * 23.0, -1.0}, {0.1, 0.05, 1.0}};
    const auto expected = firstHitOfField(plain, scene::Field::cubic_interpolating, &a, blocksA, 0.03, ray);
    const auto found =
        firstHitOfField(shifted, scene::Field::cubic_interpolating, &b, blocksB, offset + 0.03, ray);
    ASSERT_EQ(expected.hit.has_value(), found.hit.has_value()) << i;
    if (!expected.hit) continue;
    ++hits;
    const double slope = glm::dot(sampleCubic(a, plain, expected.hit->voxel).gradient, ray.direction);
    EXPECT_LT(std::abs(found.hit->t - expected.hit->t) * std::abs(slope), 5e-6);
  }
  EXPECT_GT(hits, 200);
}

// Voxels of the border with data all around a gap that is wider than what gets means: as if every gap had
// been filled with means to its end.
TEST(Coefficients, WhatStandsFarInAGapDoesNotReachTheData) {
  const glm::ivec3 dims(90, 12, 12);
  const auto isData = [](int x) { return x < 10 || x >= 82; };
  std::vector<float> gaps, filled;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) {
        const float v = isData(x) ? (x < 10 ? 100.0f : -60.0f) : std::nanf("");
        gaps.push_back(v);
        filled.push_back(isData(x) ? v : x < 46 ? 100.0f : -60.0f);  // constant means on both sides
      }
  const GridGeometry geometry = GridGeometry::make(dims, glm::dvec3(1));
  const Grid a(geometry, std::move(gaps)), b(geometry, std::move(filled));
  const Coefficients ca = interpolatingCoefficients(a), cb = interpolatingCoefficients(b);
  for (int x = 0; x < dims.x; ++x)
    if (isData(x)) {
      const std::size_t i = a.index(x, 5, 6);
      EXPECT_NEAR(ca.offset + static_cast<double>(ca.values[i]),
                  cb.offset + static_cast<double>(cb.values[i]), 160.0 * 3e-7)
          << x;
    }
}

// Ratio to the cost without gaps in the same run, in time of the processor: about 5; it was 60 with means to
// the middle of every gap, found by looking at all that is left again and again.
TEST(Coefficients, GapsCostAFewTimesWhatDataCost) {
  const GridGeometry geometry = test::unitGeometry(glm::ivec3(128));
  const auto ball = [](glm::dvec3 p) { return 20.0 - glm::distance(p, glm::dvec3(63.5)); };
  const Grid whole = gridOfVoxels(geometry, ball);
  const Grid gaps = gridOfVoxels(geometry, [&](glm::dvec3 p) {
    const double v = ball(p);
    return v < -20.0 ? std::numeric_limits<double>::quiet_NaN() : v;
  });
  const double plain = test::processorSeconds([&] { interpolatingCoefficients(whole); });
  const double filled = test::processorSeconds([&] { interpolatingCoefficients(gaps); });
  RecordProperty("ratio", std::to_string(filled / plain));
  EXPECT_LT(filled, 20.0 * plain);
}

TEST(Coefficients, AStopLeavesMostOfTheRestUndone) {
  const Grid gaps = gridOfVoxels(test::unitGeometry(glm::ivec3(192)), [](glm::dvec3 p) {
    const double v = 40.0 - glm::distance(p, glm::dvec3(95.5));
    return v < -20.0 ? std::numeric_limits<double>::quiet_NaN() : v;
  });
  test::expectStopsSoon([&](base::Progress& progress) { interpolatingCoefficients(gaps, progress); }, 5);
}

TEST(Coefficients, AskTheMemoryBudgetAndSayWhatNeedsLess) {
  const Grid grid = gridOfVoxels(GridGeometry::make(glm::ivec3(16), glm::dvec3(1)),
                                 [](const glm::dvec3& p) { return p.x; });
  const std::size_t before = base::machineMemory().held();
  {
    const Coefficients made = interpolatingCoefficients(grid);
    EXPECT_EQ(base::machineMemory().held(), before + 4 * 16 * 16 * 16);
  }
  EXPECT_EQ(base::machineMemory().held(), before);
  const test::MemoryLimit limit(4 * 16 * 16 * 16 - 1);
  try {
    interpolatingCoefficients(grid);
    FAIL() << "the budget was not asked";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::memory);
    EXPECT_NE(error.reason().find("hit.field"), std::string::npos) << error.reason();
  }
}

}  // namespace
}  // namespace isolux::volume
