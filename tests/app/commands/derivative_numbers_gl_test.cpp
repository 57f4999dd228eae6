// --explain and --stats say the numbers that decide a picture, and say the same: noise, scales, the ends of
// the colours, where lines begin, and how much of what is seen has no curvature to speak of.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/number_text.h"
#include "tests/app/commands/run_isolux.h"
#include "tests/support/test_data.h"

namespace isolux::app {
namespace {

using nlohmann::json;
using testing::HasSubstr;

struct Told {
  json derivatives;
  std::string text;
};

Told told(std::vector<std::string> settings) {
  const auto folder = test::temporaryFolder();
  std::vector<std::string> line{"render", "phantom:torus:32", "--size",  "96x80", "--out",
                                "a.png",  "--explain",        "--stats", "s.json"};
  for (const std::string& setting : settings) line.insert(line.end(), {"--set", setting});
  const test::RunResult result = test::runIsolux(line, {.folder = folder});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  return {json::parse(test::contentOf(folder / "s.json"))["derivatives"], result.out};
}

TEST(DerivativeNumbersGl, ExplainSaysTheNumbersOfTheStats) {
  const Told of = told({"look.mode=mean_curvature"});
  ASSERT_EQ(of.derivatives["range"].size(), 2u);
  const double low = of.derivatives["range"][0], high = of.derivatives["range"][1];
  EXPECT_LT(low, high);
  EXPECT_THAT(of.text, HasSubstr("colours: " + base::shortText(low, 4) + " to " + base::shortText(high, 4) +
                                 " 1/mm, automatic: of the whole surface"));
  EXPECT_THAT(of.text, HasSubstr("noise of a voxel: " +
                                 base::shortText(of.derivatives["noise"].get<double>(), 3) + ", automatic"));
  EXPECT_THAT(of.text, HasSubstr("scale of curvature: " +
                                 base::shortText(of.derivatives["scale_mm"].get<double>(), 3) + " mm"));
  EXPECT_THAT(of.derivatives["automatic"], testing::Contains("noise"));
  EXPECT_LT(of.derivatives["unknown_share"].get<double>(), 0.2);
  EXPECT_THAT(of.text, HasSubstr("curvature is not significant (confidence below 0.5) on "));
}

TEST(DerivativeNumbersGl, WhatIsSetIsToldAsSet) {
  const Told of = told({"look.mode=kappa1", "look.range_low=-0.5", "look.range_high=0.25",
                        "derivatives.noise=0.125", "look.ridges=1", "look.ridge_threshold=0.0625"});
  EXPECT_EQ(of.derivatives["noise"], 0.125);
  EXPECT_EQ(of.derivatives["range"], json({-0.5, 0.25}));
  EXPECT_EQ(of.derivatives["ridge_thresholds"], json({0.0625, 0.0625}));
  EXPECT_THAT(of.text, HasSubstr("noise of a voxel: 0.125, as set"));
  EXPECT_THAT(of.text, HasSubstr("colours: -0.5 to 0.25 1/mm, as set"));
  EXPECT_THAT(of.text, HasSubstr("lines: ridges from 0.0625, valleys from 0.0625 1/mm, as set"));
  EXPECT_THAT(of.derivatives["automatic"], testing::Not(testing::Contains("noise")));
}

TEST(DerivativeNumbersGl, NoiseAsLargeAsTheGradientLeavesNoCurvature) {
  const Told of = told(
      {"look.mode=kappa1", "derivatives.noise=1000", "derivatives.scale=0", "derivatives.normal_scale=0"});
  EXPECT_GT(of.derivatives["unknown_share"].get<double>(), 0.99);
  EXPECT_THAT(
      of.text,
      HasSubstr("curvature is not significant (confidence below 0.5) on 100.0 % of the visible surface"));
}

TEST(DerivativeNumbersGl, APictureWithoutCurvatureSaysNothingOfIt) {
  const Told of = told({"look.mode=depth"});
  EXPECT_TRUE(of.derivatives["unknown_share"].is_null());
  EXPECT_THAT(of.text, testing::Not(HasSubstr("curvature is not significant")));
}

}  // namespace
}  // namespace isolux::app
