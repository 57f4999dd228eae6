// isolux info --pieces: the pieces of an isosurface, as a table and as JSON.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/commands/run_isolux.h"
#include "tests/support/test_data.h"

namespace isolux::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

std::string outputOf(std::vector<std::string> arguments) {
  const RunResult result = callIsolux(arguments, temporaryFolder());
  EXPECT_EQ(result.exitCode, 0) << result.err;
  return result.out;
}

TEST(PiecesCommand, ABallIsOnePiece) {
  const json pieces = json::parse(outputOf({"info", "phantom:ball:64", "--pieces", "--json"}))["pieces"];
  EXPECT_EQ(pieces["count"], 1);
  ASSERT_EQ(pieces["list"].size(), 1u);
  const json& ball = pieces["list"][0];
  EXPECT_EQ(ball["id"], 0);
  EXPECT_TRUE(ball["shown"].get<bool>());
  const double radius = 0.35 * 63.0;  // voxels of 1 mm about the world's origin
  EXPECT_LE(std::abs(ball["volume_mm3"]["value"].get<double>() -
                     4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3)),
            ball["volume_mm3"]["error"].get<double>());
  EXPECT_LE(std::abs(ball["area_mm2"]["value"].get<double>() - 4.0 * std::numbers::pi * radius * radius),
            ball["area_mm2"]["error"].get<double>());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(ball["bounds_mm"][0][axis].get<double>(), -radius, 0.05);
    EXPECT_NEAR(ball["bounds_mm"][1][axis].get<double>(), radius, 0.05);
    EXPECT_NEAR(ball["seed_mm"][axis].get<double>(), 0.0, 0.51);
  }
}

TEST(PiecesCommand, SettingsSayWhatIsShown) {
  const json pieces = json::parse(
      outputOf({"info", "phantom:ball:32", "--pieces", "--json", "--set", "pieces.hidden=0,0,0"}))["pieces"];
  ASSERT_EQ(pieces["list"].size(), 1u);
  EXPECT_FALSE(pieces["list"][0]["shown"].get<bool>());
}

TEST(PiecesCommand, TheTableHasALineForEach) {
  const std::string text = outputOf({"info", "phantom:ball:32", "--pieces"});
  EXPECT_THAT(text, HasSubstr("pieces        1, inside is above isovalue 0"));
  EXPECT_THAT(text, HasSubstr("volume mm^3"));
  EXPECT_THAT(outputOf({"info", "phantom:ball:32", "--pieces", "--isovalue", "1e9"}),
              HasSubstr("pieces        0,"));
  EXPECT_THAT(outputOf({"info", "phantom:ball:32"}), testing::Not(HasSubstr("pieces ")));
}

}  // namespace
}  // namespace isolux::test
