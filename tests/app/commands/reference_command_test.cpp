// Runs `isolux reference`: no graphics context is needed.
#include <cmath>
#include <csignal>
#include <fstream>
#include <numbers>

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/files/image_io.h"
#include "base/color.h"
#include "scene/rules/tone_curve.h"
#include "tests/app/commands/run_isolux.h"
#include "tests/support/png_reader.h"
#include "tests/support/poll.h"
#include "tests/support/test_data.h"

namespace isolux::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::contentOf;
using test::filesIn;
using test::runIsolux;
using test::RunResult;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct Exr {
  OIIO::ImageSpec spec;
  std::vector<float> values;

  explicit Exr(const fs::path& file) {
    const auto input = OIIO::ImageInput::open(file.string());
    if (!input) return;
    spec = input->spec();
    values.resize(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) *
                  static_cast<std::size_t>(spec.nchannels));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data())) values.clear();
  }
  float at(int x, int y, const char* channel) const {
    return values.at(
        static_cast<std::size_t>((y * spec.width + x) * spec.nchannels + spec.channelindex(channel)));
  }
};

TEST(ReferenceCommand, ABallUnderTheSkyIsAsBrightAsTheFormulaSays) {
  const fs::path folder = test::temporaryFolder();
  const RunResult result =
      runIsolux({"reference", "phantom:ball:32", "--size", "31x21", "--spp", "8", "--out", "a.exr", "--stats",
                 "s.json", "--set", "light.environment.constant=0.5,0.5,0.5", "--set",
                 "isosurface.albedo=0.8,0.4,0.2", "--set", "picture.exposure=1"},
                {.folder = folder});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const Exr image(folder / "a.exr");
  EXPECT_THAT(image.spec.channelnames,
              testing::UnorderedElementsAre("R", "G", "B", "irradiance.R", "irradiance.G", "irradiance.B",
                                            "variance", "samples", "hit"));
  ASSERT_FALSE(image.values.empty());
  EXPECT_EQ(image.at(15, 10, "hit"), 1.0f);
  EXPECT_EQ(image.at(15, 10, "samples"), 8.0f);
  EXPECT_NEAR(image.at(15, 10, "irradiance.G"), std::numbers::pi / 2.0, 1e-4);
  EXPECT_NEAR(image.at(15, 10, "R"), 0.8, 1e-4);  // albedo * E / pi * 2
  EXPECT_NEAR(image.at(15, 10, "B"), 0.2, 1e-4);
  EXPECT_EQ(image.at(0, 0, "hit"), 0.0f);
  EXPECT_TRUE(std::isnan(image.at(0, 0, "R")) && std::isnan(image.at(0, 0, "irradiance.R")) &&
              std::isnan(image.at(0, 0, "samples")));

  const json stats = json::parse(contentOf(folder / "s.json"));
  int hits = 0;
  for (int y = 0; y < 21; ++y)
    for (int x = 0; x < 31; ++x) hits += image.at(x, y, "hit") > 0.0f ? 1 : 0;
  EXPECT_EQ(stats["pixels_hit"], hits);
  EXPECT_EQ(stats["rays"], 8 * hits);
  EXPECT_NEAR(stats["mean_irradiance"].get<double>(), std::numbers::pi / 2.0, 1e-4);
  EXPECT_EQ(stats["capped_paths"], 0);
  for (const char* key :
       {"version", "size", "samples", "pixels_traced", "standard_error", "seconds", "threads", "data_hash"})
    EXPECT_TRUE(stats.contains(key)) << key;
}

TEST(ReferenceCommand, TheNumberOfThreadsDoesNotMatter) {
  const fs::path folder = test::temporaryFolder();
  for (const char* threads : {"1", "3"})
    ASSERT_EQ(runIsolux({"reference", "phantom:gyroid:24", "--size", "24x24", "--spp", "20", "--threads",
                         threads, "--out", std::string(threads) + ".exr"},
                        {.folder = folder})
                  .exitCode,
              0);
  const Exr one(folder / "1.exr"), three(folder / "3.exr");
  ASSERT_EQ(one.values.size(), three.values.size());
  ASSERT_FALSE(one.values.empty());
  for (std::size_t i = 0; i < one.values.size(); ++i) {
    if (!std::isnan(one.values[i])) {
      EXPECT_EQ(one.values[i], three.values[i]);
    }
  }
}

TEST(ReferenceCommand, APngIsWhatAScreenShowsAndCarriesItsSession) {
  const fs::path folder = test::temporaryFolder();
  ASSERT_EQ(
      runIsolux({"reference", "phantom:ball:24", "--size", "24x24", "--spp", "4", "--look", "gi", "--set",
                 "gi.bounces=0", "--set", "isosurface.albedo=0.2,0.5,1", "--set",
                 "light.environment.constant=1,1,1", "--set", "picture.metering=lights", "--out", "a.png"},
                {.folder = folder})
          .exitCode,
      0);
  const render::ColorImage image = test::readPng(folder / "a.png");
  ASSERT_EQ(image.size, glm::ivec2(24));
  // A convex body under a sky of radiance 1 shows its albedo, through the tone curve of pictures.
  const std::size_t middle = 4 * (12 * 24 + 12);
  const glm::dvec3 shown = scene::filmic(glm::dvec3(0.2, 0.5, 1.0));
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(image.rgba[middle + static_cast<std::size_t>(c)], 255.0 * base::encodeSrgb(shown[c]), 2.0);
  EXPECT_THAT(app::readSessionText(folder / "a.png"), HasSubstr("phantom:ball:24"));
}

// A yardstick of another brightness would be no yardstick: it is exposed as the picture is.
TEST(ReferenceCommand, TakesThePicturesExposure) {
  const fs::path folder = test::temporaryFolder();
  const auto middle = [&](const char* metering) {
    EXPECT_EQ(runIsolux({"reference", "phantom:ball:24", "--size", "24x24", "--spp", "4", "--look", "gi",
                         "--set", "gi.bounces=0", "--set", "isosurface.albedo=0.05,0.05,0.05", "--set",
                         "light.environment.constant=1,1,1", "--set",
                         std::string("picture.metering=") + metering, "--out", "a.png"},
                        {.folder = folder})
                  .exitCode,
              0);
    return static_cast<int>(test::readPng(folder / "a.png").rgba[4 * (12 * 24 + 12)]);
  };
  EXPECT_NEAR(middle("lights"), 255.0 * base::encodeSrgb(0.05), 2.0)
      << "a white surface would be nearly white";
  EXPECT_NEAR(middle("surface"), 255.0 * base::encodeSrgb(0.339 * 0.05 / 0.6), 2.0)
      << "a surface that reflects 0.6 would be of middle grey (docs/explanation/global-illumination.md)";
}

TEST(ReferenceCommand, WrongUseIsOneLine) {
  const fs::path folder = test::temporaryFolder();
  const auto refused = [&](std::vector<std::string> options, int exitCode, const char* word) {
    options.insert(options.begin(), {"reference", "phantom:ball:16", "--size", "8x8"});
    const RunResult result = runIsolux(options, {.folder = folder});
    EXPECT_EQ(result.exitCode, exitCode) << word;
    EXPECT_TRUE(result.isOneErrorLine()) << result.err;
    EXPECT_THAT(result.err, HasSubstr(word));
  };
  refused({"--out", "a.jpg"}, 2, ".exr");
  refused({"--out", "a.exr", "--spp", "0"}, 2, "--spp");
  refused({"--out", "a.exr", "--set", "isosurface.opacity=0.5"}, 2, "opaque");
  refused({"--out", "none/a.exr"}, 3, "none");
  refused({"--out", "a.exr", "--set", "light.environment.file=none.hdr"}, 3, "none.hdr");
  EXPECT_THAT(filesIn(folder), IsEmpty());
}

TEST(ReferenceCommand, AClosedCavityOfAlbedoOneSaysThatPathsWereEnded) {
  const fs::path folder = test::temporaryFolder();
  // Inside below: the ball is a cavity; the eye is in its middle.
  const RunResult result = runIsolux({"reference", "phantom:ball:16",
                                      "--size",    "2x2",
                                      "--spp",     "2",
                                      "--out",     "a.exr",
                                      "--set",     "isosurface.inside=below",
                                      "--set",     "isosurface.albedo=1,1,1",
                                      "--set",     "light.environment.constant=1,1,1",
                                      "--set",     "gi.bounces=1000",
                                      "--camera",  "0,0,0 0,1,0 0,0,1 40",
                                      "--stats",   "s.json"},
                                     {.folder = folder});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("8 paths were ended after 1000 bounces"));
  EXPECT_EQ(json::parse(contentOf(folder / "s.json"))["capped_paths"], 8);
}

TEST(ReferenceCommand, AnInterruptLeavesThePictureSoFar) {
  const fs::path folder = test::temporaryFolder(), file = folder / "a.exr";
  test::RunningIsolux running(
      {"reference", "phantom:ball:48", "--size", "96x96", "--spp", "1000000", "--out", "a.exr"},
      {.folder = folder});
  ASSERT_TRUE(test::pollUntil([&] { return fs::exists(file); }));
  running.signal(SIGINT);
  const RunResult result = running.wait();
  EXPECT_EQ(result.exitCode, 130);
  EXPECT_EQ(result.err, "isolux: interrupted\n");
  EXPECT_THAT(filesIn(folder), ElementsAre("a.exr"));
  const Exr image(file);
  ASSERT_FALSE(image.values.empty());
  EXPECT_EQ(image.at(48, 48, "hit"), 1.0f);
  EXPECT_GE(image.at(48, 48, "samples"), 1.0f);
  EXPECT_TRUE(std::isfinite(image.at(48, 48, "irradiance.R")));
}

}  // namespace
}  // namespace isolux::app
