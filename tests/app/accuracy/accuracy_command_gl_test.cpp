// isolux render --accuracy and --aov error_*: what is said, what is written, and that nothing runs unasked.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/accuracy/error_images.h"
#include "app/documents/session.h"
#include "app/files/image_io.h"
#include "base/error.h"
#include "tests/app/commands/run_isolux.h"
#include "tests/support/test_data.h"

namespace isolux::app {
namespace {

using nlohmann::json;
using testing::HasSubstr;

test::RunResult render(const std::filesystem::path& folder, const std::vector<std::string>& more) {
  std::vector<std::string> line{"render", "phantom:torus:32", "--size", "96x80", "--stats", "s.json"};
  line.insert(line.end(), more.begin(), more.end());
  const test::RunResult result = test::runIsolux(line, {.folder = folder});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  return result;
}

TEST(AccuracyCommandGl, StatsAndExplainSayTheSame) {
  const auto folder = test::temporaryFolder();
  const test::RunResult result = render(folder, {"--out", "a.png", "--accuracy", "--explain"});
  const json accuracy = json::parse(test::contentOf(folder / "s.json"))["accuracy"];
  EXPECT_EQ(accuracy["pixels"], 96 * 80);
  EXPECT_GT(accuracy["seen"], 500);
  for (const char* const bound : {"depth_mm", "normal_degrees", "kappa_per_mm", "kappa_relative"}) {
    EXPECT_GT(accuracy[bound]["median"].get<double>(), 0.0) << bound;
    EXPECT_LE(accuracy[bound]["median"], accuracy[bound]["most_99"]) << bound;
  }
  EXPECT_LT(accuracy["depth_mm"]["most_99"].get<double>(), 1e-2);
  EXPECT_LT(accuracy["not_certain_share"].get<double>(), 0.01);
  EXPECT_GT(accuracy["noise"]["depth_mm"]["most_99"].get<double>(),
            accuracy["depth_mm"]["most_99"].get<double>())
      << "what a user must know comes first";
  EXPECT_THAT(
      result.out,
      HasSubstr("error bounds at the 99th percentile of visible pixels: depth by noise and sampling ± "));
  EXPECT_THAT(result.out, HasSubstr("by arithmetic: depth ± "));
  EXPECT_THAT(result.out, HasSubstr("% of pixels are not certain"));
}

TEST(AccuracyCommandGl, ThePictureCarriesItAndDrawsTheSame) {
  const auto folder = test::temporaryFolder();
  render(folder, {"--out", "a.png", "--accuracy", "--set", "camera.fov=33"});
  const json session = json::parse(readSessionText(folder / "a.png"));
  EXPECT_EQ(session["accuracy"], json::parse(test::contentOf(folder / "s.json"))["accuracy"]);
  EXPECT_EQ(loadSession(folder / "a.png").camera.fov, 33.0);
  render(folder, {"--out", "b.png"});
  EXPECT_FALSE(json::parse(readSessionText(folder / "b.png")).contains("accuracy"));
}

// Noise of deviation s moves the surface by s / |gradient|: 1 mm / mm here, seen from the front.
TEST(AccuracyCommandGl, NoiseOfTheDataIsToldInMillimetresOfDepth) {
  const auto folder = test::temporaryFolder();
  const auto most = [&](const char* noise) {
    render(folder, {"--out", "a.png", "--accuracy", "--set", std::string("derivatives.noise=") + noise});
    return json::parse(test::contentOf(folder / "s.json"))["accuracy"]["noise"]["depth_mm"]["median"]
        .get<double>();
  };
  const double small = most("0.001"), large = most("0.1");
  EXPECT_GT(large - small, 0.2) << "two deviations, and along the ray";
  EXPECT_LT(large - small, 0.6) << "beside what sampling costs";
}

TEST(AccuracyCommandGl, NothingRunsUnasked) {
  const auto folder = test::temporaryFolder();
  const std::size_t before = pictureErrorRuns();
  ASSERT_EQ(test::callIsolux({"render", "phantom:torus:32", "--size", "96x80", "--out", "a.png", "--explain",
                              "--stats", "s.json"},
                             folder)
                .exitCode,
            0);
  EXPECT_EQ(pictureErrorRuns(), before);
  EXPECT_TRUE(json::parse(test::contentOf(folder / "s.json"))["accuracy"].is_null());
  ASSERT_EQ(
      test::callIsolux(
          {"render", "phantom:torus:32", "--size", "96x80", "--out", "a.exr", "--aov", "error_depth"}, folder)
          .exitCode,
      0);
  EXPECT_EQ(pictureErrorRuns(), before + 1);
}

TEST(AccuracyCommandGl, StoredLightIsBoundedAndOverlaid) {
  const auto folder = test::temporaryFolder();
  const test::RunResult result = render(folder, {"--out", "a.png", "--look", "gi", "--set", "gi.samples=4",
                                                 "--error-overlay", "light", "--explain"});
  const json light = json::parse(test::contentOf(folder / "s.json"))["accuracy"]["light"];
  EXPECT_EQ(light["level"], 0.95);
  EXPECT_GT(light["relative"]["median"].get<double>(), 1e-4);
  EXPECT_LE(light["relative"]["median"], light["relative"]["most_99"]);
  EXPECT_GT(light["relative_within"].get<double>(), 1e-4);
  EXPECT_THAT(result.out, HasSubstr("light of 95 % of it ± "));
  render(folder, {"--out", "plain.png", "--look", "gi", "--set", "gi.samples=4"});
  EXPECT_NE(test::contentOf(folder / "a.png"), test::contentOf(folder / "plain.png"));
}

TEST(AccuracyCommandGl, LightIsBakedForItsErrorsWhateverTheLook) {
  const auto folder = test::temporaryFolder();
  render(folder, {"--out", "a.exr", "--aov", "error_light", "--look", "kappa1", "--set", "gi.samples=4"});
  const json stats = json::parse(test::contentOf(folder / "s.json"));
  EXPECT_GT(stats["accuracy"]["light"]["irradiance"]["median"].get<double>(), 0.0);
  render(folder, {"--out", "b.png", "--accuracy"});
  EXPECT_TRUE(json::parse(test::contentOf(folder / "s.json"))["accuracy"]["light"].is_null());
}

TEST(AccuracyCommandGl, AnOverlayThatMakesNoSenseIsRefused) {
  const auto folder = test::temporaryFolder();
  const auto codeOf = [&](const std::vector<std::string>& more) {
    std::vector<std::string> line{"render", "phantom:torus:24", "--size", "64x48"};
    line.insert(line.end(), more.begin(), more.end());
    return test::runIsolux(line, {.folder = folder}).exitCode;
  };
  EXPECT_EQ(codeOf({"--out", "a.exr", "--error-overlay", "depth"}), 2);
  EXPECT_EQ(codeOf({"--out", "a.png", "--error-overlay", "limits"}), 2);
  EXPECT_EQ(codeOf({"--out", "a.png", "--error-overlay", "light"}), 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}

TEST(AccuracyCommandGl, ErrorsAreChannelsOfTheFile) {
  const WantedImages wanted = parseImageList("error_normal,depth,error_depth,normal");
  const std::vector<render::Aov> aovs{render::Aov::depth, render::Aov::normal};
  EXPECT_EQ(wanted.aovs, aovs);
  PictureErrors errors;
  errors.size = {1, 1};
  errors.depthMm = {0.5f};
  errors.normalDegrees = {0.25f};
  const std::vector<FloatChannel> channels = channelsOf(
      {{render::Aov::depth, {1, 1}, 1, {7.0f}}, {render::Aov::normal, {1, 1}, 3, {1.0f, 2.0f, 3.0f}}}, wanted,
      errors);
  std::vector<std::string> names;
  for (const FloatChannel& channel : channels) names.push_back(channel.name);
  EXPECT_THAT(names, testing::ElementsAre("depth", "normal.x", "normal.y", "normal.z", "error_normal",
                                          "error_depth"));
  EXPECT_EQ(channels[2].values, std::vector<float>{2.0f});
  EXPECT_EQ(channels[4].values, errors.normalDegrees);
  EXPECT_THROW(parseImageList("error_nothing"), base::Error);
}

}  // namespace
}  // namespace isolux::app
