// The (kappa1, kappa2) colour map against what inverse-distance weights must give.
#include "scene/curvature_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace isolux::test {

using scene::CurvaturePoint;

TEST(CurvatureMap, IsExactAtItsPointsAndNowhereOutsideTheirColours) {
  const auto points = scene::automaticCurvaturePoints();
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
  const auto points = scene::automaticCurvaturePoints();
  EXPECT_EQ(scene::curvatureColor(points, {9.0, -4.0}), scene::curvatureColor(points, {1.0, -1.0}));
  const std::vector<CurvaturePoint> twice = {{0.2, 0.1, glm::dvec3(1.0)}, {0.2, 0.1, glm::dvec3(0.0)}};
  EXPECT_EQ(scene::curvatureColor(twice, {0.2, 0.1}), glm::dvec3(0.5));
  EXPECT_NEAR(scene::curvatureColor(twice, {0.2 + 1e-9, 0.1}).x, 0.5, 1e-12);
  const glm::dvec3 alone = scene::curvatureColor(std::vector<CurvaturePoint>{points[1]}, {-0.3, -0.9});
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(alone[c], points[1].color[c], 1e-15);
}

TEST(CurvatureMap, TexelsLieAtTheirCentres) {
  const auto points = scene::automaticCurvaturePoints();
  scene::Look look;
  look.curvaturePoints = points;
  const auto texels = scene::curvatureTexels(look, 8);
  ASSERT_EQ(texels.size(), 64U);
  // Column 6, row 1: kappa1 = 13/8 - 1, kappa2 = 3/8 - 1.
  const glm::vec3 expected(scene::curvatureColor(points, {0.625, -0.625}));
  EXPECT_EQ(texels[1 * 8 + 6], expected);
  look.curvaturePoints.reset();
  EXPECT_EQ(scene::curvatureTexels(look, 8)[1 * 8 + 6],
            glm::vec3(scene::automaticCurvatureColor({0.625, -0.625})));
}

namespace {

// Ottosson's OKLab as its definition states it: linear BT.709, cone responses, cube roots.
glm::dvec3 oklabOf(const glm::dvec3& rgb) {
  const double l = std::cbrt(0.4122214708 * rgb.r + 0.5363325363 * rgb.g + 0.0514459929 * rgb.b);
  const double m = std::cbrt(0.2119034982 * rgb.r + 0.6806995451 * rgb.g + 0.1073969566 * rgb.b);
  const double s = std::cbrt(0.0883024619 * rgb.r + 0.2817188376 * rgb.g + 0.6299787005 * rgb.b);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

}  // namespace

TEST(CurvatureMap, TheAutomaticOneIsOfOneLightnessGreyWhereFlatAndHasAHueForEachShape) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  for (int i = 0; i < 1000; ++i) {
    const double a = part(random), b = part(random);
    const glm::dvec2 kappa(std::max(a, b), std::min(a, b));
    const glm::dvec3 lab = oklabOf(scene::automaticCurvatureColor(kappa));
    EXPECT_NEAR(lab.x, oklabOf(scene::automaticCurvatureColor({0.0, 0.0})).x, 1e-3);
    const double chroma = std::hypot(lab.y, lab.z), curvedness = glm::length(kappa);
    if (curvedness > 0.3) {
      EXPECT_GT(chroma, 0.08);  // far from grey
    }
    if (curvedness < 0.01) continue;
    // Even steps: 137.5 degrees of hue for each step of the shape index.
    const double shape = std::atan2(kappa.x + kappa.y, kappa.x - kappa.y) * 2.0 / std::numbers::pi;
    const double hue = std::atan2(lab.z, lab.y) * 180.0 / std::numbers::pi;
    EXPECT_NEAR(std::remainder(hue - (162.5 - 137.5 * shape), 360.0), 0.0, 0.5);
  }
  const glm::dvec3 flat = oklabOf(scene::automaticCurvatureColor({0.0, 0.0}));
  EXPECT_LT(std::hypot(flat.y, flat.z), 1e-3);
}

}  // namespace isolux::test
