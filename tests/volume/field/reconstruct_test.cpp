#include "volume/field/reconstruct.h"
#include "tests/support/rays.h"
#include "tests/support/volumes.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "base/random.h"
#include "tests/support/analytic_fields.h"

namespace isolux::volume {
namespace {

using test::gridOfVoxels;
using test::randomPoint;

TEST(Reconstruct, LinearFieldsAreExact) {
  const glm::dvec3 slope(2.0, -3.0, 0.5);
  const Grid grid = gridOfVoxels(test::unitGeometry(glm::ivec3(12)),
                                 [&](glm::dvec3 p) { return 7.0 + glm::dot(slope, p); });
  for (std::uint64_t i = 0; i < 200; ++i) {
    const glm::dvec3 p = randomPoint(i, glm::dvec3(1), glm::dvec3(10));
    for (const FieldSample& s : {sampleTrilinear(grid, p), sampleCubic(grid, p)}) {
      EXPECT_NEAR(s.value, 7.0 + glm::dot(slope, p), 1e-12);
      EXPECT_LT(glm::distance(s.gradient, slope), 1e-12);
      for (int c = 0; c < 3; ++c) EXPECT_LT(glm::length(s.hessian[c]), 1e-12);
    }
  }
}

TEST(Reconstruct, TrilinearTakesTheSamplesAndTheTrilinearTerms) {
  const auto f = [](glm::dvec3 p) {
    return 1 + p.x - 2 * p.y + 3 * p.z + p.x * p.y - 0.5 * p.y * p.z + 0.25 * p.x * p.y * p.z;
  };
  const Grid grid =
      gridOfVoxels(test::unitGeometry(glm::ivec3(4)), f);  // one polynomial: trilinear in every cell
  for (std::uint64_t i = 0; i < 100; ++i) {
    const glm::dvec3 p = randomPoint(i, glm::dvec3(0), glm::dvec3(3));
    const FieldSample s = sampleTrilinear(grid, p);
    EXPECT_NEAR(s.value, f(p), 1e-12);
    EXPECT_NEAR(s.gradient.x, 1 + p.y + 0.25 * p.y * p.z, 1e-12);
    EXPECT_NEAR(s.gradient.z, 3 - 0.5 * p.y + 0.25 * p.x * p.y, 1e-12);
    EXPECT_NEAR(s.hessian[0][1], 1 + 0.25 * p.z, 1e-12);
    EXPECT_NEAR(s.hessian[2][1], -0.5 + 0.25 * p.x, 1e-12);
    EXPECT_EQ(s.hessian[0][0], 0.0);
  }
  EXPECT_EQ(sampleTrilinear(grid, {3, 3, 3}).value, grid.value(3, 3, 3));
}

TEST(Reconstruct, CubicOfAQuadraticIsTheQuadraticPlusAThirdOfItsCurvature) {
  // The B-spline blurs with variance 1/3 per axis: f + sum of f_ii / 6, with exact derivatives.
  const auto f = [](glm::dvec3 p) { return 0.5 * p.x * p.x - p.y * p.y + p.x * p.z + 2.0 * p.z; };
  const Grid grid = gridOfVoxels(test::unitGeometry(glm::ivec3(12)), f);
  for (std::uint64_t i = 0; i < 100; ++i) {
    const glm::dvec3 p = randomPoint(i, glm::dvec3(1), glm::dvec3(10));
    const FieldSample s = sampleCubic(grid, p);
    EXPECT_NEAR(s.value, f(p) + (1.0 - 2.0) / 6.0, 1e-11);
    EXPECT_LT(glm::distance(s.gradient, glm::dvec3(p.x + p.z, -2.0 * p.y, p.x + 2.0)), 1e-11);
    EXPECT_NEAR(s.hessian[0][0], 1.0, 1e-11);
    EXPECT_NEAR(s.hessian[1][1], -2.0, 1e-11);
    EXPECT_NEAR(s.hessian[2][0], 1.0, 1e-11);
    EXPECT_NEAR(s.hessian[0][2], 1.0, 1e-11);
  }
}

TEST(Reconstruct, CubicDerivativesAgreeWithDifferencesOfItsValue) {
  const Grid grid = gridOfVoxels(test::unitGeometry(glm::ivec3(10)), [](glm::dvec3 p) {
    return base::uniformNoise(3, static_cast<std::uint64_t>(p.x + 10 * p.y + 100 * p.z));
  });
  for (std::uint64_t i = 0; i < 50; ++i) {
    const glm::dvec3 p = randomPoint(i, glm::dvec3(0.01), glm::dvec3(8.99));
    const FieldSample s = sampleCubic(grid, p);
    const test::Derivatives d =
        test::differences([&](glm::dvec3 q) { return sampleCubic(grid, q).value; }, p, 1e-4);
    EXPECT_LT(glm::distance(s.gradient, d.gradient), 1e-6);
    // Where a difference reaches over a knot, its error is that of the jump in the third derivative.
    for (int c = 0; c < 3; ++c) EXPECT_LT(glm::distance(s.hessian[c], d.hessian[c]), 1e-3);
  }
}

TEST(Reconstruct, OutsideTheDomainPositionsAreClamped) {
  const Grid grid =
      gridOfVoxels(test::unitGeometry(glm::ivec3(5)), [](glm::dvec3 p) { return p.x * p.y + p.z; });
  const glm::dvec3 outside(-3.0, 9.0, 2.5), border(0.0, 4.0, 2.5);
  EXPECT_EQ(sampleTrilinear(grid, outside).value, sampleTrilinear(grid, border).value);
  EXPECT_EQ(sampleCubic(grid, outside).value, sampleCubic(grid, border).value);
  EXPECT_EQ(sampleCubic(grid, outside).gradient, sampleCubic(grid, border).gradient);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isfinite(sampleCubic(grid, glm::dvec3(nan)).value));
  EXPECT_TRUE(std::isfinite(sampleTrilinear(grid, glm::dvec3(nan)).value));
}

TEST(Reconstruct, OneAndTwoVoxelAxesWork) {
  const Grid grid =
      gridOfVoxels(GridGeometry::make({1, 2, 6}, glm::dvec3(1)), [](glm::dvec3 p) { return 3 * p.y + p.z; });
  const FieldSample line = sampleTrilinear(grid, {0.0, 0.25, 3.5});
  EXPECT_NEAR(line.value, 4.25, 1e-12);
  EXPECT_EQ(line.gradient, glm::dvec3(0, 3, 1));
  const FieldSample cubic = sampleCubic(grid, {0.0, 0.5, 2.5});
  EXPECT_NEAR(cubic.value, 4.0, 1e-12);
  EXPECT_NEAR(cubic.gradient.x, 0.0, 1e-12);
  EXPECT_NEAR(cubic.gradient.z, 1.0, 1e-12);
}

TEST(Reconstruct, SlopeAndInterceptScaleValuesAndDerivatives) {
  std::vector<std::int16_t> voxels;
  for (int i = 0; i < 64; ++i) voxels.push_back(static_cast<std::int16_t>(i * i));
  const Grid plain(test::unitGeometry(glm::ivec3(4)), voxels),
      scaled(test::unitGeometry(glm::ivec3(4)), voxels, -0.5, 100.0);
  const glm::dvec3 p(1.3, 2.2, 0.7);
  EXPECT_NEAR(sampleCubic(scaled, p).value, 100.0 - 0.5 * sampleCubic(plain, p).value, 1e-9);
  EXPECT_LT(glm::length(sampleCubic(scaled, p).gradient + 0.5 * sampleCubic(plain, p).gradient), 1e-9);
  EXPECT_NEAR(sampleTrilinear(scaled, p).value, 100.0 - 0.5 * sampleTrilinear(plain, p).value, 1e-9);
}

TEST(Reconstruct, WorldDerivativesFollowTheAffine) {
  // A field given in the world, sampled through an oblique, left-handed affine.
  const GridGeometry geometry = test::obliqueLeftHandedGeometry(12);
  const glm::dvec3 slope(0.3, -2.0, 1.1);
  const auto world = [&](glm::dvec3 voxel) {
    return glm::dvec3(geometry.worldFromVoxel * glm::dvec4(voxel, 1));
  };
  const Grid grid = gridOfVoxels(geometry, [&](glm::dvec3 voxel) {
    const glm::dvec3 p = world(voxel);
    return glm::dot(slope, p) + 0.05 * p.x * p.y - 0.02 * p.z * p.z;
  });
  const glm::dvec3 voxel(5.3, 6.1, 4.8), p = world(voxel);
  const FieldSample s = sampleCubic(grid, voxel);
  EXPECT_LT(glm::distance(worldGradient(geometry, s.gradient),
                          slope + glm::dvec3(0.05 * p.y, 0.05 * p.x, -0.04 * p.z)),
            1e-5);
  const glm::dmat3 hessian = worldHessian(geometry, s.hessian);
  EXPECT_NEAR(hessian[0][1], 0.05, 1e-5);
  EXPECT_NEAR(hessian[1][0], 0.05, 1e-5);
  EXPECT_NEAR(hessian[2][2], -0.04, 1e-5);
  EXPECT_NEAR(hessian[0][0], 0.0, 1e-5);
}

TEST(Reconstruct, TinyAndHugeOffsetsKeepTheirDifferences) {
  const Grid tiny = gridOfVoxels(test::unitGeometry(glm::ivec3(4)), [](glm::dvec3 p) { return 1e-20 * p.x; });
  EXPECT_NEAR(sampleCubic(tiny, {1.5, 1.5, 1.5}).gradient.x / 1e-20, 1.0, 1e-6);
  const Grid huge =
      gridOfVoxels(test::unitGeometry(glm::ivec3(4)), [](glm::dvec3 p) { return 1e6 + 0.0625 * p.x; });
  EXPECT_NEAR(sampleCubic(huge, {1.5, 1.5, 1.5}).gradient.x, 0.0625, 1e-8);
}

}  // namespace
}  // namespace isolux::volume
