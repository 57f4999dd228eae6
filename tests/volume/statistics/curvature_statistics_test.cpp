#include "volume/statistics/curvature_statistics.h"
#include "tests/support/volumes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/quantiles.h"
#include "tests/support/analytic_fields.h"
#include "tests/support/rays.h"
#include "tests/support/unwatched.h"
#include "volume/field/reconstruct.h"

namespace isolux::volume {
namespace {

using scene::LookMode;

struct Subject {
  Subject(const std::string& name, const GridGeometry& geometry)
      : grid(test::phantomGrid(name, geometry)), blocks(grid, 8, progress) {}
  base::Progress progress;
  Grid grid;
  MinMaxBlocks blocks;
};

void expectAll(const Quantiles& q, double value, double tolerance) {
  EXPECT_NEAR(q.low, value, tolerance);
  EXPECT_NEAR(q.median, value, tolerance);
  EXPECT_NEAR(q.high, value, tolerance);
}

TEST(CurvatureStatistics, OfABallAreItsRadius) {
  for (const GridGeometry& geometry : {test::isotropicGeometry(96), test::obliqueLeftHandedGeometry(96)}) {
    const Subject ball("ball", geometry);
    const Coefficients coefficients = interpolatingCoefficients(ball.grid);
    const CurvatureStatistics s = curvatureStatistics(ball.grid, ball.blocks, 0.0, -1.0, &coefficients);
    const glm::dvec3 spacing = geometry.spacingMm();
    const double k = 1.0 / (0.35 * 95.0 * std::min({spacing.x, spacing.y, spacing.z}));
    EXPECT_EQ(s.samples, 2000u);
    expectAll(s.of(LookMode::kappa1), k, 0.02 * k);
    expectAll(s.of(LookMode::kappa2), k, 0.02 * k);
    expectAll(s.of(LookMode::mean_curvature), k, 0.02 * k);
    expectAll(s.of(LookMode::gaussian_curvature), k * k, 0.04 * k * k);
    expectAll(s.of(LookMode::curvedness), k, 0.02 * k);
    // Seen from inside.
    expectAll(curvatureStatistics(ball.grid, ball.blocks, 0.0, 1.0).of(LookMode::mean_curvature), -k,
              0.02 * k);
  }
}

// Noise that bends every voxel's surface leaves the ball's curvature at a scale.
TEST(CurvatureStatistics, AtAScaleSeeThroughNoise) {
  const GridGeometry geometry = test::isotropicGeometry(64);
  const Subject ball("ball", geometry);
  const Grid noisy = test::withNoise(ball.grid, 0.5 * geometry.spacingMm().x, glm::dvec3(0.0), 3);
  base::Progress progress;
  const MinMaxBlocks blocks(noisy, 8, progress);
  const ScaledField scaled = scaledField(noisy, scene::Field::cubic, 3.0 * geometry.spacingMm().x, progress);
  const double k = 1.0 / (0.35 * 63.0 * geometry.spacingMm().x);
  const Quantiles plain = curvatureStatistics(noisy, blocks, 0.0).of(LookMode::mean_curvature),
                  found = curvatureStatistics(noisy, blocks, 0.0, -1.0, nullptr, &scaled)
                              .of(LookMode::mean_curvature);
  EXPECT_NEAR(found.median, k, 0.05 * k);
  EXPECT_NEAR(found.low, k, 0.5 * k);
  EXPECT_NEAR(found.high, k, 0.5 * k);
  EXPECT_GT(plain.high - plain.low, 5.0 * (found.high - found.low));
}

TEST(CurvatureStatistics, OfATorusAreThoseOfWhatCanBeSeenOfItsClosedForm) {
  const GridGeometry geometry = test::isotropicGeometry(128);
  const Subject torus("torus", geometry);
  const CurvatureStatistics s = curvatureStatistics(torus.grid, torus.blocks, 0.0);
  const double minor = 0.12 * 127.0;
  expectAll(s.of(LookMode::kappa1), 1.0 / minor, 0.03 / minor);
  // First hits of rays of every direction, by formula; ten directions stand for all of them.
  const auto field = test::analyticField("torus", geometry);
  std::vector<double> seen;
  for (std::uint64_t i = 0; seen.size() < 20000; ++i) {
    const glm::dvec3 direction = glm::normalize(2.0 * test::randomVector(i, 1) - 1.0 + 1e-9),
                     part = test::randomVector(i, 2);
    if (glm::length(2.0 * test::randomVector(i, 1) - 1.0) > 1.0) continue;  // even on the sphere
    const glm::dvec3 right = glm::normalize(glm::cross(direction, glm::dvec3(0.6, 0.8, 0.0)));
    const glm::dvec3 centre = glm::dvec3(geometry.worldFromVoxel * glm::dvec4(glm::dvec3(63.5), 1.0));
    const glm::dvec3 start =
        centre + 130.0 * ((part.x - 0.5) * right + (part.y - 0.5) * glm::cross(right, direction) - direction);
    if (const auto t = field->firstHit(start, direction, 0.0))
      seen.push_back(field->curvature(start + *t * direction).kappa2);
  }
  const auto quantile = [&](double part) { return base::quantile(seen, part); };
  EXPECT_NEAR(s.of(LookMode::kappa2).low, quantile(0.05), 0.006);
  EXPECT_NEAR(s.of(LookMode::kappa2).median, quantile(0.5), 0.004);
  EXPECT_NEAR(s.of(LookMode::kappa2).high, quantile(0.95), 0.002);
}

// A cavity is bent ten times as much as all that can be seen.
TEST(CurvatureStatistics, AreOfWhatCanBeSeen) {
  const Grid grid = test::gridOfVoxels(test::unitGeometry(glm::ivec3(96)), [](glm::dvec3 p) {
    const double r = glm::length(p - glm::dvec3(47.5));
    const glm::dvec3 q = (p - glm::dvec3(47.5)) / 8.0 - glm::round((p - glm::dvec3(47.5)) / 8.0);
    return std::min(40.0 - r, r > 32.0 ? 100.0 : 8.0 * glm::length(q) - 3.0);
  });
  base::Progress progress;
  const CurvatureStatistics s = curvatureStatistics(grid, MinMaxBlocks(grid, 8, progress), 0.0);
  expectAll(s.of(LookMode::kappa1), 1.0 / 40.0, 0.1 / 40.0);
}

TEST(CurvatureStatistics, WithoutASurfaceAreZero) {
  const Subject ball("ball", test::isotropicGeometry(24));
  for (const double isovalue : {1000.0, -1000.0, std::nan("")})
    EXPECT_EQ(curvatureStatistics(ball.grid, ball.blocks, isovalue).samples, 0u);
  base::Progress progress;
  const Grid flat(GridGeometry::make({9, 1, 9}, glm::dvec3(1)), std::vector<float>(81, 1.0f));
  EXPECT_EQ(curvatureStatistics(flat, MinMaxBlocks(flat, 8, progress), 1.0).samples, 0u);
}

TEST(CurvatureStatistics, MissingVoxelsLeaveFiniteNumbers) {
  const GridGeometry geometry = test::isotropicGeometry(32);
  auto voxels = std::get<std::vector<float>>(test::phantomGrid("ball", geometry).voxels());
  for (std::size_t i = 0; i < voxels.size(); i += 97) voxels[i] = std::numeric_limits<float>::quiet_NaN();
  const Grid grid(geometry, voxels);
  base::Progress progress;
  const CurvatureStatistics s = curvatureStatistics(grid, MinMaxBlocks(grid, 8, progress), 0.0);
  EXPECT_GT(s.samples, 100u);
  EXPECT_EQ(s.measures.size(), 7u);
  for (const auto& [look, q] : s.measures)
    EXPECT_TRUE(std::isfinite(q.low) && std::isfinite(q.median) && std::isfinite(q.high))
        << scene::lookInfo(look).name;
  // Beside a missing voxel there is no curvature; elsewhere it is the ball's.
  const double k = 1.0 / (0.35 * 31.0 * geometry.spacingMm().x);
  expectAll(s.of(LookMode::kappa1), k, 0.1 * k);
}

}  // namespace
}  // namespace isolux::volume
