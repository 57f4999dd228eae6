// Automatic ranges and thresholds: pure arithmetic on a surface's statistics.
#include "render/passes/curvature_ranges.h"

#include <cmath>

#include <gtest/gtest.h>

namespace isolux::render {
namespace {

using scene::LookMode;
using volume::CurvatureStatistics;

CurvatureStatistics some() {
  CurvatureStatistics s;
  s.samples = 100;
  s.measures = {{LookMode::kappa1, {-0.1, 0.1, 0.4}},
                {LookMode::kappa2, {-0.3, 0.0, 0.2}},
                {LookMode::mean_curvature, {-0.2, 0.05, 0.3}},
                {LookMode::gaussian_curvature, {-0.04, 0.0, 0.02}},
                {LookMode::curvedness, {0.01, 0.1, 0.35}}};
  return s;
}
constexpr double kFlat = 1e-3;

glm::dvec2 rangeOf(LookMode mode, const CurvatureStatistics& s = some()) {
  scene::Scene scene;
  scene.look.mode = mode;
  return measureRange(scene, s, kFlat);
}

TEST(CurvatureRangesTest, SignedMeasuresAreSymmetric) {
  EXPECT_EQ(rangeOf(LookMode::kappa1), glm::dvec2(-0.4, 0.4));
  EXPECT_EQ(rangeOf(LookMode::kappa2), glm::dvec2(-0.3, 0.3));
  EXPECT_EQ(rangeOf(LookMode::mean_curvature), glm::dvec2(-0.3, 0.3));
  EXPECT_EQ(rangeOf(LookMode::gaussian_curvature), glm::dvec2(-0.04, 0.04));
  EXPECT_EQ(rangeOf(LookMode::curvature_2d), glm::dvec2(-0.4, 0.4));
  EXPECT_EQ(rangeOf(LookMode::curvedness), glm::dvec2(0.0, 0.35));
  EXPECT_EQ(rangeOf(LookMode::shape_index), glm::dvec2(-1.0, 1.0));
}

TEST(CurvatureRangesTest, WhatIsFlatHasARangeToo) {
  const CurvatureStatistics none;
  EXPECT_EQ(rangeOf(LookMode::kappa1, none), glm::dvec2(-kFlat, kFlat));
  EXPECT_EQ(rangeOf(LookMode::gaussian_curvature, none), glm::dvec2(-kFlat * kFlat, kFlat * kFlat));
  EXPECT_EQ(rangeOf(LookMode::curvedness, none), glm::dvec2(0.0, kFlat));
  EXPECT_EQ(curvatureScale(none, kFlat), kFlat);
  EXPECT_EQ(ridgeThresholds({}, none, kFlat), glm::dvec2(kFlat));
  const glm::dvec2 longest = ridgeLengths({}, glm::dvec2(0.0));
  EXPECT_TRUE(std::isfinite(longest.x) && std::isfinite(longest.y));
}

TEST(CurvatureRangesTest, FixedEndsAreKept) {
  scene::Scene scene;
  scene.look.mode = LookMode::kappa1;
  scene.look.rangeLow = 0.05;
  EXPECT_EQ(measureRange(scene, some(), kFlat), glm::dvec2(0.05, 0.4));
  EXPECT_TRUE(readsCurvatureRanges(scene));
  scene.look.rangeHigh = -0.5;  // swapped: the map is turned around
  EXPECT_EQ(measureRange(scene, some(), kFlat), glm::dvec2(0.05, -0.5));
  EXPECT_FALSE(readsCurvatureRanges(scene));
  scene.look.mode = LookMode::curvature_2d;
  EXPECT_EQ(measureRange(scene, some(), kFlat), glm::dvec2(-0.5, 0.5));
}

TEST(CurvatureRangesTest, EndsThatAreAutomaticAreTold) {
  scene::Scene scene;
  EXPECT_TRUE(foundNumbers(scene, some(), kFlat).empty());
  scene.look.mode = LookMode::kappa1;
  const glm::dvec2 range = measureRange(scene, some(), kFlat);
  EXPECT_EQ(foundNumbers(scene, some(), kFlat),
            (std::map<std::string, double>{{"look.range_low", range.x}, {"look.range_high", range.y}}));
  scene.look.rangeLow = -2.0;
  EXPECT_EQ(foundNumbers(scene, some(), kFlat),
            (std::map<std::string, double>{{"look.range_high", range.y}}));
}

TEST(CurvatureRangesTest, RidgesAndValleysHaveThresholdsOfTheirOwn) {
  scene::Scene scene;
  EXPECT_EQ(ridgeThresholds(scene, some(), kFlat), glm::dvec2(0.75 * 0.4, 0.75 * 0.3));
  CurvatureStatistics convex = some();
  convex.measures[LookMode::kappa2] = {0.01, 0.02, 0.03};
  EXPECT_EQ(ridgeThresholds(scene, convex, kFlat), glm::dvec2(0.75 * 0.4, 0.25 * 0.75 * 0.4));
  scene.look.ridgeThreshold = 0.2;
  EXPECT_EQ(ridgeThresholds(scene, some(), kFlat), glm::dvec2(0.2));
  EXPECT_EQ(ridgeLengths(scene, {0.2, 0.1}), glm::dvec2(5.0, 10.0));
  scene.look.ridgeLength = 3.0;
  EXPECT_EQ(ridgeLengths(scene, {0.2, 0.1}), glm::dvec2(3.0));
}

TEST(CurvatureRangesTest, SeveralSurfacesShareTheOuterBounds) {
  CurvatureStatistics other;
  other.samples = 50;
  other.measures[LookMode::kappa1] = {-0.5, 0.0, 0.1};
  const CurvatureStatistics both = outerBounds({CurvatureStatistics{}, some(), other});
  EXPECT_EQ(both.samples, 150u);
  EXPECT_EQ(both.of(LookMode::kappa1).low, -0.5);
  EXPECT_EQ(both.of(LookMode::kappa1).high, 0.4);
  EXPECT_EQ(both.of(LookMode::kappa2).low, -0.3);  // not the empty surface's 0
}

}  // namespace
}  // namespace isolux::render
