// Shapes of quadrics, whose B-spline has the quadric's own derivatives, and what bounds say of known shifts.
#include "volume/error/derivative_error.h"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "volume/error/hit_error.h"

namespace isolux::volume {
namespace {

constexpr int kNoiseSize = 17;
const glm::dvec3 kCentre(8.0);
constexpr double kDegree = std::numbers::pi / 180.0;

Grid gridOf(const glm::dvec3& spacing, const std::function<double(glm::dvec3)>& fieldOfMm,
            glm::ivec3 missing = glm::ivec3(-1)) {
  std::vector<float> values;
  for (int z = 0; z < kNoiseSize; ++z)
    for (int y = 0; y < kNoiseSize; ++y)
      for (int x = 0; x < kNoiseSize; ++x)
        values.push_back(glm::ivec3(x, y, z) == missing
                             ? std::numeric_limits<float>::quiet_NaN()
                             : static_cast<float>(fieldOfMm((glm::dvec3(x, y, z) - kCentre) * spacing)));
  return {GridGeometry::make(glm::ivec3(kNoiseSize), spacing, glm::dvec3(0.0), glm::dmat3(1.0)),
          std::move(values)};
}

// Samples are whole numbers, so that floats have them exactly.
double ballDistance(glm::dvec3 p) {
  return -glm::dot(p, p);
}

TEST(DerivativeError, ShapesOfABallAreTheClosedForm) {
  for (const glm::dvec3& spacing : {glm::dvec3(1.0), glm::dvec3(1.0, 2.0, 3.0)}) {
    const Grid grid = gridOf(spacing, ballDistance);
    const DerivedShape shape{grid};
    const glm::dvec3 voxel(10.3, 6.1, 9.7), mm = (voxel - kCentre) * spacing;
    const ShapeAt at = shapeAt(shape, voxel);
    const glm::dvec3 outward = glm::normalize(mm);
    EXPECT_LT(glm::length(at.normal - outward), 1e-12);
    ASSERT_TRUE(at.hasCurvature);
    EXPECT_NEAR(at.kappa1, 1.0 / glm::length(mm), 1e-12);
    EXPECT_NEAR(at.kappa2, 1.0 / glm::length(mm), 1e-12);
    EXPECT_NEAR(at.gradient, 2.0 * glm::length(mm), 1e-12);
    EXPECT_NEAR(at.bend, 2.0 * std::sqrt(3.0), 1e-9);
    EXPECT_NEAR(at.lean, 0.0, 1e-9);
  }
}

TEST(DerivativeError, ACylinderIsStraightAlongItsAxis) {
  const Grid grid = gridOf(glm::dvec3(1.0), [](glm::dvec3 p) { return -p.x * p.x - p.y * p.y; });
  const ShapeAt at = shapeAt({grid}, {11.0, 12.0, 8.3});
  EXPECT_NEAR(at.kappa1, 0.2, 1e-12);  // 5 mm from the axis
  EXPECT_NEAR(at.kappa2, 0.0, 1e-12);
}

TEST(DerivativeError, WhatIsKnownIsInTheBoundAsItIs) {
  const Grid grid = gridOf(glm::dvec3(1.0), ballDistance);
  const DerivedShape shape{grid};
  const glm::dvec3 voxel = kCentre + glm::dvec3(5.0, 0.0, 0.0);
  const std::vector<glm::dvec3> ends{voxel, voxel};
  const ShapeBound still = boundShape(shape, voxel, voxel, ends, glm::dvec3(0.0));
  EXPECT_GT(still.normalDegrees, 0.0);  // roundings of samples and weights
  EXPECT_LT(still.normalDegrees, 1e-3);
  // Along the ball by 0.01 mm: the normal turns, curvature stays.
  const glm::dvec3 beside = kCentre + 5.0 * glm::normalize(glm::dvec3(5.0, 0.01, 0.0));
  const ShapeBound turned = boundShape(shape, voxel, beside, ends, glm::dvec3(0.0));
  const double turn = std::atan2(0.01, 5.0) / kDegree;
  EXPECT_GE(turned.normalDegrees, turn);
  EXPECT_LE(turned.normalDegrees, turn + 2.0 * still.normalDegrees);
  // Outward by 0.01 mm: curvature falls, the normal stays.
  const ShapeBound out = boundShape(shape, voxel, voxel + glm::dvec3(0.01, 0.0, 0.0), ends, glm::dvec3(0.0));
  const double change = 1.0 / 5.0 - 1.0 / 5.01;
  EXPECT_GE(out.curvature, change);
  EXPECT_LE(out.curvature, change + 2.0 * still.curvature);
  EXPECT_NEAR(out.normalDegrees, still.normalDegrees, 0.1 * still.normalDegrees);
}

TEST(DerivativeError, WhatIsRandomIsAddedByItsSquares) {
  const Grid grid = gridOf(glm::dvec3(1.0), ballDistance);
  const DerivedShape shape{grid};
  const glm::dvec3 voxel = kCentre + glm::dvec3(5.0, 0.0, 0.0);
  const std::vector<glm::dvec3> ends{voxel, voxel};
  // Of 0.001 voxels across: 0.001 / 5 radians, at the level of the bounds.
  const ShapeBound across = boundShape(shape, voxel, voxel, ends, {0.0, 1e-3, 0.0});
  const double expected = kErrorLevel * 1e-3 / 5.0 / kDegree;
  EXPECT_NEAR(across.normalDegrees, expected, 0.02 * expected);
  const ShapeBound both = boundShape(shape, voxel, voxel, ends, {0.0, 1e-3, 1e-3});
  EXPECT_NEAR(both.normalDegrees, std::sqrt(2.0) * expected, 0.03 * expected);
}

TEST(DerivativeError, BesideAGapThereIsNoCurvatureAndNoBound) {
  const Grid grid = gridOf(glm::dvec3(1.0), ballDistance, {12, 8, 8});
  const DerivedShape shape{grid};
  EXPECT_FALSE(
      shapeAt(shape, {10.5, 8.5, 8.5}).hasCurvature);  // the spline reaches the gap, the cell does not
  EXPECT_GT(glm::length(shapeAt(shape, {10.5, 8.5, 8.5}).normal), 0.9);
  EXPECT_EQ(shapeAt(shape, {11.5, 8.5, 8.5}).normal, glm::dvec3(0.0));  // in its cell
  const glm::dvec3 voxel(6.5, 8.5, 8.5), gap(11.5, 8.5, 8.5);
  const std::vector<glm::dvec3> ends{voxel, gap};
  EXPECT_TRUE(std::isinf(boundShape(shape, voxel, voxel, ends, glm::dvec3(0.0)).normalDegrees));
  EXPECT_FALSE(
      std::isinf(boundShape(shape, voxel, voxel, std::vector{voxel, voxel}, glm::dvec3(0.0)).normalDegrees));
}

}  // namespace
}  // namespace isolux::volume
