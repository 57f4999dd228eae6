#include "volume/statistics/visible_points.h"
#include "tests/support/volumes.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/analytic_fields.h"
#include "volume/field/reconstruct.h"

namespace isolux::volume {
namespace {

std::vector<VisiblePoint> pointsOf(const Grid& grid, double isovalue, std::size_t wanted) {
  base::Progress progress;
  return visiblePoints(grid, MinMaxBlocks(grid, 8, progress), isovalue, wanted);
}

TEST(VisiblePoints, LieOnTheSurfaceAndFaceTheirRays) {
  for (const GridGeometry& geometry : {test::isotropicGeometry(48), test::obliqueLeftHandedGeometry(48)}) {
    const Grid ball = test::phantomGrid("ball", geometry);
    const auto points = pointsOf(ball, 0.0, 500);
    ASSERT_EQ(points.size(), 500u);
    for (const VisiblePoint& p : points) {
      const FieldSample field = sampleTrilinear(ball, p.voxel);
      EXPECT_NEAR(field.value, 0.0, 1e-9);
      EXPECT_NEAR(glm::length(p.direction), 1.0, 1e-12);
      EXPECT_GE(glm::dot(worldGradient(geometry, field.gradient), p.direction), -1e-6);
    }
  }
}

TEST(VisiblePoints, AreSpreadOverAllOfAConvexBody) {
  const Grid ball = test::phantomGrid("ball", test::isotropicGeometry(48));
  glm::dvec3 sum(0.0);
  std::array<int, 8> octants{};
  const auto points = pointsOf(ball, 0.0, 2000);
  for (const VisiblePoint& p : points) {
    const glm::dvec3 q = p.voxel - glm::dvec3(23.5);
    sum += glm::normalize(q) / 2000.0;
    ++octants[static_cast<std::size_t>((q.x > 0 ? 1 : 0) + (q.y > 0 ? 2 : 0) + (q.z > 0 ? 4 : 0))];
  }
  EXPECT_LT(glm::length(sum), 0.1);
  for (const int count : octants) EXPECT_NEAR(count, 250, 110);
}

TEST(VisiblePoints, DoNotLieInFolds) {
  // A shell: nobody sees its inner side.
  const Grid shell = test::gridOfVoxels(test::unitGeometry(glm::ivec3(48)), [](glm::dvec3 p) {
    return 3.0 - std::abs(glm::length(p - glm::dvec3(23.5)) - 15.0);
  });
  for (const VisiblePoint& p : pointsOf(shell, 0.0, 500))
    EXPECT_GT(glm::length(p.voxel - glm::dvec3(23.5)), 17.0);
}

TEST(VisiblePoints, AreNoneWithoutASurfaceAndFewOfASpeck) {
  const Grid ball = test::phantomGrid("ball", test::isotropicGeometry(24));
  for (const double isovalue : {1000.0, -1000.0, std::nan("")})
    EXPECT_TRUE(pointsOf(ball, isovalue, 100).empty()) << isovalue;
  Grid flat(GridGeometry::make({9, 1, 9}, glm::dvec3(1)), std::vector<float>(81, 1.0f));
  EXPECT_TRUE(pointsOf(flat, 1.0, 100).empty());
}

}  // namespace
}  // namespace isolux::volume
