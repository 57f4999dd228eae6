// The first picture under global illumination, as `isolux render FILE --look gi` draws it: it has shape, and
// is neither dark nor burnt. And what `--environment` and the exposure mean on the command line.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/documents/session.h"
#include "scene/rules/environment.h"
#include "tests/app/commands/run_isolux.h"
#include "tests/support/png_reader.h"
#include "tests/support/test_data.h"

namespace isolux::app {
namespace {

namespace fs = std::filesystem;
using test::runIsolux;
using test::RunResult;
using testing::HasSubstr;

const std::vector<std::string> onMagenta = {"--set", "look.background_top=1,0,1", "--set",
                                            "look.background_bottom=1,0,1"};

RunResult render(std::vector<std::string> arguments, const fs::path& folder) {
  arguments.insert(arguments.begin(), "render");
  RunResult result = runIsolux(arguments, {.folder = folder});
  EXPECT_EQ(result.exitCode, 0) << testing::PrintToString(arguments) << '\n' << result.err;
  return result;
}

struct Luma {
  double median = 0.0, deviation = 0.0;
};

// Of the surface's pixels: all that the background does not shine through.
Luma lumaOf(const render::ColorImage& image) {
  std::vector<double> luma;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const double r = image.rgba[i], g = image.rgba[i + 1], b = image.rgba[i + 2];
    if (r > g + 60.0 && b > g + 60.0) continue;
    luma.push_back(0.2126 * r + 0.7152 * g + 0.0722 * b);
  }
  if (luma.empty()) return {};
  const double mean = std::accumulate(luma.begin(), luma.end(), 0.0) / static_cast<double>(luma.size());
  double squares = 0.0;
  for (const double value : luma) squares += (value - mean) * (value - mean);
  const auto middle = luma.begin() + static_cast<std::ptrdiff_t>(luma.size() / 2);
  std::nth_element(luma.begin(), middle, luma.end());
  return {*middle, std::sqrt(squares / static_cast<double>(luma.size()))};
}

void expectShape(const std::vector<std::string>& what) {
  const fs::path folder = test::temporaryFolder();
  std::vector<std::string> arguments = what;
  arguments.insert(arguments.end(), onMagenta.begin(), onMagenta.end());
  for (const char* const more : {"--look", "gi", "--size", "256x256", "--out", "a.png"})
    arguments.emplace_back(more);
  render(arguments, folder);
  const Luma luma = lumaOf(test::readPng(folder / "a.png"));
  EXPECT_GE(luma.deviation, 30.0);
  EXPECT_GE(luma.median, 90.0);
  EXPECT_LE(luma.median, 180.0);
}

TEST(FirstLightGl, OfAPhantomHasShape) {
  expectShape({"phantom:head:96"});
}

struct Scan {
  const char *name, *file, *isovalue;  // isovalue "": the suggested one
};

class FirstLightGl : public testing::TestWithParam<Scan> {};

TEST_P(FirstLightGl, OfAScanHasShape) {
  ISOLUX_NEEDS_DATA();
  std::vector<std::string> what = {(test::dataFolder() / "volumes" / GetParam().file).string()};
  if (*GetParam().isovalue != '\0') what.insert(what.end(), {"--isovalue", GetParam().isovalue});
  expectShape(what);
}

INSTANTIATE_TEST_SUITE_P(Scans, FirstLightGl,
                         testing::Values(Scan{"bone", "ct_head_skin_bone.nii.gz", ""},
                                         Scan{"skin", "ct_head_skin_bone.nii.gz", "0.15"},
                                         Scan{"colin", "mri_colin27.nii.gz", ""},
                                         Scan{"engine", "engine.nii.gz", ""},
                                         Scan{"heptane", "heptane.nii.gz", ""}),
                         [](const auto& scan) { return scan.param.name; });

nlohmann::json exposureOf(std::vector<std::string> arguments) {
  const fs::path folder = test::temporaryFolder();
  arguments.insert(arguments.begin(), {"phantom:head:32", "--look", "gi", "--set", "gi.samples=4"});
  arguments.insert(arguments.end(), {"--out", "a.png", "--stats", "s.json"});
  render(arguments, folder);
  return nlohmann::json::parse(test::contentOf(folder / "s.json")).at("exposure");
}

TEST(ExposureGl, IsThatOfTheViewButNotOfThePicturesSizeOrThePathsPerTexel) {
  const std::string view = "300,200,-10 0,0,0 0,0,1 20";
  const nlohmann::json first = exposureOf({"--size", "64x48"});
  EXPECT_EQ(first.at("from"), "surface");
  const nlohmann::json seen = exposureOf({"--size", "64x48", "--camera", view});
  EXPECT_NE(seen, first);
  EXPECT_EQ(exposureOf({"--size", "37x90", "--set", "gi.samples=9", "--camera", view}), seen);
  EXPECT_NE(exposureOf({"--size", "64x48", "--environment", "window"}).at("stops"), first.at("stops"));
  EXPECT_EQ(exposureOf({"--size", "64x48", "--set", "picture.metering=lights"}).at("from"), "lights");
  EXPECT_EQ(exposureOf({"--size", "64x48", "--set", "picture.exposure=1.5"}).at("stops"), 1.5);
}

// As in the window, where turning the view does not change it.
TEST(ExposureGl, OfASessionIsThatOfTheFront) {
  const fs::path folder = test::temporaryFolder();
  scene::Scene scene;
  scene.source.path = "phantom:head:32";
  scene.look.mode = scene::LookMode::gi;
  scene.gi.samples = 4;
  saveSession(scene, folder / "s.isolux");
  const auto exposure = [&](const std::vector<std::string>& arguments) {
    std::vector<std::string> all = {"s.isolux", "--size", "64x48", "--out", "a.png", "--stats", "s.json"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    render(all, folder);
    return nlohmann::json::parse(test::contentOf(folder / "s.json")).at("exposure");
  };
  EXPECT_EQ(exposure({"--view", "inferior"}), exposure({}));
  EXPECT_FALSE(loadSession(folder / "a.png").picture.exposure) << "it is still automatic";
}

// A film of one exposure: no picture carries another than the first.
TEST(ExposureGl, OfATurntableIsThatOfTheFront) {
  const fs::path folder = test::temporaryFolder();
  const std::string out = render({"phantom:head:32", "--look", "gi", "--set", "gi.samples=1", "--size",
                                  "16x16", "--turntable", "2", "--explain", "--out", "turn"},
                                 folder)
                              .out;
  const auto first = out.find("exposure: "), second = out.find("exposure: ", first + 1);
  ASSERT_NE(second, std::string::npos);
  EXPECT_EQ(out.substr(first, out.find('\n', first) - first),
            out.substr(second, out.find('\n', second) - second));
}

TEST(ExposureGl, APictureIsTheSameAgainFromItsSession) {
  const fs::path folder = test::temporaryFolder();
  const RunResult made =
      render({"phantom:head:32", "--look", "gi", "--set", "gi.samples=4", "--camera",
              "300,200,-10 0,0,0 0,0,1 20", "--size", "64x48", "--explain", "--out", "a.png"},
             folder);
  EXPECT_THAT(made.out, HasSubstr("stops, by the surface"));
  render({"a.png", "--out", "b.png"}, folder);
  EXPECT_EQ(test::readPng(folder / "a.png").rgba, test::readPng(folder / "b.png").rgba);
}

TEST(EnvironmentOptionGl, TakesANameOrAFileInPlaceOfWhatThereWas) {
  const fs::path folder = test::temporaryFolder();
  scene::Scene scene;
  scene.source.path = "phantom:ball:16";
  scene.light.environment.constant = glm::dvec3(0.5);
  saveSession(scene, folder / "s.isolux");
  const auto environment = [&](const std::vector<std::string>& arguments) {
    std::vector<std::string> all = {"s.isolux", "--size", "8x8", "--out", "a.png"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    render(all, folder);
    return loadSession(folder / "a.png").light.environment;
  };
  EXPECT_EQ(scene::kindOf(environment({})), scene::EnvironmentKind::oneColor);
  const scene::Environment window = environment({"--environment", "window"});
  EXPECT_EQ(scene::kindOf(window), scene::EnvironmentKind::builtIn);
  EXPECT_EQ(window.builtIn, scene::BuiltInLight::window);
  std::ofstream(folder / "probe.hdr") << "read by looks of stored light only";
  EXPECT_EQ(scene::kindOf(environment({"--environment", "probe.hdr"})), scene::EnvironmentKind::file);
  EXPECT_EQ(scene::kindOf(environment({"--environment", "probe.hdr", "--environment", "studio"})),
            scene::EnvironmentKind::builtIn);
  EXPECT_EQ(environment({"--set", "light.environment.constant=1,2,3"}).constant, glm::dvec3(1.0, 2.0, 3.0));
}

}  // namespace
}  // namespace isolux::app
