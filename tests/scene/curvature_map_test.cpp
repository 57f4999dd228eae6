// The (kappa1, kappa2) colour map against what inverse-distance weights must give.
#include "scene/curvature_map.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace isolux::test {

using scene::CurvaturePoint;

TEST(CurvatureMap, IsExactAtItsPointsAndNowhereOutsideTheirColours) {
  const auto points = scene::Look::defaultCurvaturePoints();
  for (const CurvaturePoint& point : points)
    EXPECT_EQ(scene::curvatureColor(points, {point.kappa1, point.kappa2}), point.color);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> kappa(-1.0, 1.0);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 color = scene::curvatureColor(points, {kappa(random), kappa(random)});
    for (int c = 0; c < 3; ++c) {
      const auto [least, most] =
          std::minmax_element(points.begin(), points.end(),
                              [c](const auto& a, const auto& b) { return a.color[c] < b.color[c]; });
      EXPECT_GE(color[c], least->color[c] - 1e-12);
      EXPECT_LE(color[c], most->color[c] + 1e-12);
    }
  }
}

TEST(CurvatureMap, WeighsByTheInverseSquareOfTheDistance) {
  const std::vector<CurvaturePoint> points = {{-1.0, 0.0, {1.0, 0.0, 0.0}}, {1.0, 0.0, {0.0, 1.0, 0.0}}};
  const glm::dvec3 middle = scene::curvatureColor(points, {0.0, -0.7});
  EXPECT_NEAR(middle.x, 0.5, 1e-15);
  // Three times as far from the first: a ninth of the weight.
  const glm::dvec3 off = scene::curvatureColor(points, {0.5, 0.0});
  EXPECT_NEAR(off.x, 0.1, 1e-15);
  EXPECT_NEAR(off.y, 0.9, 1e-15);
}

TEST(CurvatureMap, ClampsToItsRangeAndSharesCoincidentPoints) {
  const auto points = scene::Look::defaultCurvaturePoints();
  EXPECT_EQ(scene::curvatureColor(points, {9.0, -4.0}), scene::curvatureColor(points, {1.0, -1.0}));
  const std::vector<CurvaturePoint> twice = {{0.2, 0.1, glm::dvec3(1.0)}, {0.2, 0.1, glm::dvec3(0.0)}};
  EXPECT_EQ(scene::curvatureColor(twice, {0.2, 0.1}), glm::dvec3(0.5));
  EXPECT_NEAR(scene::curvatureColor(twice, {0.2 + 1e-9, 0.1}).x, 0.5, 1e-12);
  const glm::dvec3 alone = scene::curvatureColor(std::vector<CurvaturePoint>{points[1]}, {-0.3, -0.9});
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(alone[c], points[1].color[c], 1e-15);
}

TEST(CurvatureMap, TexelsLieAtTheirCentres) {
  const auto points = scene::Look::defaultCurvaturePoints();
  const auto texels = scene::curvatureTexels(points, 8);
  ASSERT_EQ(texels.size(), 64U);
  // Column 6, row 1: kappa1 = 13/8 - 1, kappa2 = 3/8 - 1.
  const glm::vec3 expected(scene::curvatureColor(points, {0.625, -0.625}));
  EXPECT_EQ(texels[1 * 8 + 6], expected);
}

}  // namespace isolux::test
