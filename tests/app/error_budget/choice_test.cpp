#include "app/error_budget/choice.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isolux::app {
namespace {

using testing::ElementsAre;

MeasuredCandidate made(double cost, double depthMm, double missed, int supersampling = 1) {
  MeasuredCandidate one;
  one.candidate.cost = cost;
  one.candidate.supersampling = supersampling;
  one.errors[indexOf(Quantity::depthMm)] = {depthMm, depthMm, depthMm};
  one.errors[indexOf(Quantity::missed)] = {missed, missed, missed};
  return one;
}

std::vector<Limit> limits(double depthMm, double missed) {
  return {{Quantity::depthMm, depthMm}, {Quantity::missed, missed}};
}

TEST(Choice, TakesTheCheapestThatKeepsEveryLimit) {
  const std::vector<MeasuredCandidate> measured{made(3.0, 0.001, 0.0), made(1.0, 0.5, 0.0),
                                                made(2.0, 0.01, 0.1), made(2.5, 0.01, 0.01)};
  EXPECT_EQ(cheapestThatKeeps(measured, limits(1.0, 1.0)), 1u);
  EXPECT_EQ(cheapestThatKeeps(measured, limits(0.01, 1.0)), 2u);
  EXPECT_EQ(cheapestThatKeeps(measured, limits(0.01, 0.05)), 3u);
  EXPECT_EQ(cheapestThatKeeps(measured, limits(0.01, 0.0)), 0u);
  EXPECT_EQ(cheapestThatKeeps(measured, limits(0.0001, 1.0)), std::nullopt);
  EXPECT_EQ(nearestTo(measured, limits(0.0001, 1.0)), 0u);
}

TEST(Choice, WhatWasNotMeasuredKeepsNothing) {
  const std::vector<MeasuredCandidate> measured{made(1.0, std::nan(""), 0.0)};
  EXPECT_EQ(cheapestThatKeeps(measured, limits(1e9, 1.0)), std::nullopt);
  EXPECT_EQ(cheapestThatKeeps(measured, {{limits(1e9, 1.0)[1]}}), 0u);
}

TEST(Choice, BoundsLieAboveWhatWasMeasured) {
  Errors errors;
  errors.surface = 10000;
  errors.missed = 7;
  errors.invented = 3;
  errors.depthMm.most99 = 0.02;
  const TargetErrors bounds = surfaceErrors(errors, Measuring::few, true);
  EXPECT_EQ(bounds[indexOf(Quantity::depthMm)].value, 0.02);
  EXPECT_EQ(bounds[indexOf(Quantity::depthMm)].bound, 1.25 * 0.02);
  EXPECT_EQ(bounds[indexOf(Quantity::missed)].value, 0.001);
  // The mean of which 10 or fewer are seen in 0.1 % of pictures is 24.13; clusters widen that.
  EXPECT_GT(bounds[indexOf(Quantity::missed)].bound, 24.13e-4);
  EXPECT_LT(bounds[indexOf(Quantity::missed)].bound, 30e-4);
  EXPECT_TRUE(std::isnan(bounds[indexOf(Quantity::light)].bound));

  const TargetErrors own = surfaceErrors(errors, Measuring::picture, false);
  EXPECT_EQ(own[indexOf(Quantity::depthMm)].bound, 0.02) << "measured on the picture itself";
  EXPECT_EQ(own[indexOf(Quantity::missed)].bound, 0.001);
  const Limit between{Quantity::depthMm, 0.021};
  EXPECT_FALSE(keeps(bounds, std::span(&between, 1)));
  EXPECT_TRUE(mayKeep(bounds, std::span(&between, 1)));
  const Limit far{Quantity::depthMm, 0.015};
  EXPECT_FALSE(mayKeep(bounds, std::span(&far, 1)));
  // The mean of which 10 or more are seen in 0.1 % of pictures is 2.96.
  EXPECT_LT(bounds[indexOf(Quantity::missed)].least, 2.96e-4);

  errors.missed = errors.invented = 0;
  EXPECT_EQ(surfaceErrors(errors, Measuring::few, true)[indexOf(Quantity::missed)].bound, 0.0);
  const ErrorBound none = surfaceErrors(errors, Measuring::many, false)[indexOf(Quantity::missed)];
  EXPECT_GT(none.bound, 6.91e-4) << "-ln 0.001";
  EXPECT_EQ(none.least, 0.0) << "none found may be none";

  LightErrors light;
  light.mean = 2.0;
  light.rmse = 0.1;
  light.rmseStandardError = 0.01;
  const ErrorBound few = lightBound(light, Measuring::few), most = lightBound(light, Measuring::most);
  EXPECT_DOUBLE_EQ(few.value, 0.05);
  EXPECT_DOUBLE_EQ(few.bound, 0.065);
  EXPECT_DOUBLE_EQ(few.least, 0.035);
  EXPECT_DOUBLE_EQ(most.bound, 0.055);
  EXPECT_DOUBLE_EQ(most.least, 0.045);
}

// Errors within half a unit count as none: then rays per pixel, then errors, then work.
TEST(Choice, AccuracyComesFirstThenRaysThenWork) {
  const std::vector<MeasuredCandidate> measured{made(16.0, 0.001, 0.0, 4), made(1.0, 0.002, 0.0, 1),
                                                made(0.5, 0.9, 0.0, 1), made(8.0, 0.9, 0.0, 4),
                                                made(9.0, 0.95, 0.0, 4)};
  // The last is beaten by the one before.
  EXPECT_THAT(byAccuracy(measured, limits(0.01, 0.001)), ElementsAre(0, 1, 3, 2));
}

}  // namespace
}  // namespace isolux::app
