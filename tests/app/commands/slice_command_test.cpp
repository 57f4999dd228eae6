// isolux slice: numbers, pictures, what it says of them, and what it refuses.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/commands/run_isolux.h"
#include "tests/support/png_reader.h"
#include "tests/support/test_data.h"
#include "tests/support/volumes.h"
#include "volume/field/reconstruct.h"

namespace isolux::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

constexpr double kSliceRadius = 0.35 * 31.0;  // of phantom:ball:32, mm, about the world's origin

class SliceCommand : public testing::Test {
 protected:
  RunResult run(const std::vector<std::string>& arguments) {
    std::vector<std::string> all{"slice"};
    for (const std::string& argument : arguments) all.push_back(argument);
    return callIsolux(all, folder_);
  }
  json statsOf(std::vector<std::string> arguments) {
    arguments.emplace_back("--stats");
    arguments.emplace_back("stats.json");
    const RunResult result = run(arguments);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return json::parse(std::ifstream(folder_ / "stats.json"));
  }
  void expectRefused(int exitCode, const std::vector<std::string>& arguments, const std::string& words) {
    const RunResult result = run(arguments);
    EXPECT_EQ(result.exitCode, exitCode) << testing::PrintToString(arguments) << result.err;
    EXPECT_TRUE(result.isOneErrorLine()) << result.err;
    EXPECT_THAT(result.err, HasSubstr(words));
  }
  fs::path folder_ = temporaryFolder();
};

glm::dvec3 vectorOf(const json& list) {
  return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

struct Pixels {
  int width = 0, height = 0;
  std::vector<std::string> channels;
  std::vector<float> values;
};

Pixels readExr(const fs::path& file) {
  const auto in = OIIO::ImageInput::open(file.string());
  if (!in) return {};
  Pixels pixels{in->spec().width, in->spec().height, in->spec().channelnames, {}};
  pixels.values.resize(static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height));
  EXPECT_EQ(in->spec().format, OIIO::TypeDesc::FLOAT);
  EXPECT_TRUE(in->read_image(0, 0, 0, 1, OIIO::TypeDesc::FLOAT, pixels.values.data()));
  return pixels;
}

TEST_F(SliceCommand, AnExrHasTheValuesWhereTheStatisticsSay) {
  const volume::Grid grid = phantomGrid("ball", 32);
  const glm::dmat4 voxelFromWorld = grid.geometry().voxelFromWorld();
  for (const std::string plane : {"axial", "coronal", "1,-2,3 1,2,2"}) {
    const json stats = statsOf({"phantom:ball:32", "--plane", plane, "--at", "1.25", "--out", "ball.exr"});
    const Pixels image = readExr(folder_ / "ball.exr");
    ASSERT_EQ(image.channels, std::vector<std::string>{"value"});
    ASSERT_EQ(stats["size"], (json{image.width, image.height}));
    const glm::dvec3 origin = vectorOf(stats["origin_mm"]), right = vectorOf(stats["right_mm"]),
                     down = vectorOf(stats["down_mm"]);
    std::size_t values = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const glm::dvec3 voxel(voxelFromWorld *
                               glm::dvec4(origin + double(x) * right + double(y) * down, 1.0));
        const glm::dvec3 beyond = glm::max(-voxel, voxel - 31.0);
        const double outside = std::max({beyond.x, beyond.y, beyond.z});
        const float value = image.values[static_cast<std::size_t>(y * image.width + x)];
        if (std::abs(outside) < 1e-5) continue;
        ASSERT_EQ(std::isnan(value), outside > 0.0);
        if (outside > 0.0) continue;
        ++values;
        ASSERT_NEAR(value, sampleTrilinear(grid, voxel).value, 1e-5);
      }
    EXPECT_GT(values, 700u);
  }
}

TEST_F(SliceCommand, ItsContourIsTheBallsCircle) {
  const json stats = statsOf({"phantom:ball:32", "--plane", "sagittal", "--at", "4", "--out", "ball.png",
                              "--size", "300x200", "--set", "isosurface.albedo=1,0,0"});
  ASSERT_EQ(stats["contours"].size(), 1u);
  EXPECT_EQ(stats["contours"][0]["curves"], 1);
  EXPECT_EQ(stats["contours"][0]["closed"], 1);
  const double circle = std::sqrt(kSliceRadius * kSliceRadius - 16.0);
  EXPECT_NEAR(stats["contours"][0]["length_mm"].get<double>(), 2.0 * std::numbers::pi * circle, 0.3);
  EXPECT_EQ(stats["letters"]["left"], "\u2212Y");  // a ball has no sides
  EXPECT_EQ(stats["convention"], "orientation not stated");
  // Red where the circle passes, grey 3 mm from it.
  const render::ColorImage image = test::readPng(folder_ / "ball.png");
  ASSERT_EQ(image.size, glm::ivec2(300, 200));
  const glm::dvec3 origin = vectorOf(stats["origin_mm"]), right = vectorOf(stats["right_mm"]),
                   down = vectorOf(stats["down_mm"]);
  for (const double mm : {0.0, -3.0})
    for (int i = 0; i < 32; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / 32.0;
      const glm::dvec3 from =
          glm::dvec3(4.0, (circle + mm) * std::cos(angle), (circle + mm) * std::sin(angle)) - origin;
      const auto x = static_cast<int>(std::lround(glm::dot(from, right) / glm::dot(right, right)));
      const auto y = static_cast<int>(std::lround(glm::dot(from, down) / glm::dot(down, down)));
      const std::uint8_t* pixel = &image.rgba[4 * static_cast<std::size_t>(y * 300 + x)];
      if (mm == 0.0)
        EXPECT_GT(pixel[0], pixel[1] + 60) << i;
      else
        EXPECT_EQ(pixel[0], pixel[1]) << i;
    }
}

TEST_F(SliceCommand, LevelAndWidthAreThoseGiven) {
  const json stats = statsOf({"phantom:ball:32", "--plane", "axial", "--out", "ball.png", "--set",
                              "slice.level=1.5", "--set", "slice.width=7", "--set", "slice.slab=4", "--set",
                              "slice.slab_mode=maximum", "--set", "slice.contour_width=0"});
  EXPECT_EQ(stats["level"], 1.5);
  EXPECT_EQ(stats["width"], 7.0);
  EXPECT_EQ(stats["slab_mm"], 4.0);
  EXPECT_EQ(stats["slab_mode"], "maximum");
  EXPECT_TRUE(stats["contours"].empty());
}

TEST_F(SliceCommand, SaysThatThePlaneLiesBesideTheVolume) {
  const RunResult result = run({"phantom:ball:16", "--plane", "axial", "--at", "99", "--out", "none.exr"});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(result.err, HasSubstr("does not meet the volume"));
}

TEST_F(SliceCommand, RefusesInOneLine) {
  expectRefused(2, {"phantom:ball:16", "--plane", "tilted", "--out", "a.png"}, "--plane");
  expectRefused(2, {"phantom:ball:16", "--plane", "0,0,0 0,0,0", "--out", "a.png"}, "normal");
  expectRefused(2, {"phantom:ball:16", "--plane", "0,0,0", "--out", "a.png"}, "--plane");
  expectRefused(2, {"phantom:ball:16", "--plane", "axial", "--at", "nan", "--out", "a.png"}, "--at");
  expectRefused(2, {"phantom:ball:16", "--plane", "axial", "--out", "a.jpg"}, ".png or .exr");
  expectRefused(2, {"phantom:ball:16", "--plane", "axial", "--out", "a.png", "--size", "0x3"}, "--size");
  expectRefused(2, {"phantom:ball:16", "--plane", "axial", "--out", "a.png", "--stats", "a.png"}, "a.png");
  expectRefused(2, {"phantom:ball:16", "--out", "a.png"}, "--plane");
  expectRefused(3, {"nothing.nii", "--plane", "axial", "--out", "a.png"}, "nothing.nii");
  EXPECT_EQ(filesIn(folder_), std::vector<std::string>{});
}

TEST_F(SliceCommand, HelpListsWhatASliceDependsOn) {
  const RunResult help = run({"--help"});
  EXPECT_EQ(help.exitCode, 0);
  for (const char* const listed : {"--plane", "--set", "--isovalue", "--session", "--raw"})
    EXPECT_THAT(help.out, HasSubstr(listed));
  for (const char* const hidden : {"--look", "--camera", "--environment", "--executor"})
    EXPECT_THAT(help.out, testing::Not(HasSubstr(hidden)));
  // Lines of before still work.
  EXPECT_EQ(run({"phantom:ball:16", "--plane", "axial", "--out", "a.png", "--look", "tone", "--camera",
                 "0,-9,0 0,0,0 0,0,1 30"})
                .exitCode,
            0);
}

TEST_F(SliceCommand, APictureSaysWhichCurveHasWhichIsovalue) {
  const std::vector<std::string> line{"phantom:head:24",
                                      "--plane",
                                      "axial",
                                      "--size",
                                      "240x200",
                                      "--set",
                                      "isosurface2.shown=1",
                                      "--set",
                                      "isosurface2.value=-300"};
  const auto picture = [&](const char* name, const char* more) {
    std::vector<std::string> all = line;
    all.insert(all.end(), {"--out", name, "--set", more});
    EXPECT_EQ(run(all).exitCode, 0);
    return test::readPng(folder_ / name);
  };
  const render::ColorImage with = picture("with.png", "isosurface2.albedo=0,1,0"),
                           without = picture("without.png", "slice.contour_width=0");
  int green = 0;
  for (int y = 0; y < 50; ++y)
    for (int x = 160; x < 240; ++x) {
      const auto at = 4 * static_cast<std::size_t>(y * 240 + x);
      green += with.rgba[at] == 0 && with.rgba[at + 1] == 255 && with.rgba[at + 2] == 0;
      EXPECT_FALSE(without.rgba[at] == 0 && without.rgba[at + 1] == 255);
    }
  EXPECT_GT(green, 15) << "a sample at the upper right";
}

}  // namespace
}  // namespace isolux::test
