// Runs `isolux study`: needs a graphics context, software is enough.
#include <cmath>
#include <csignal>
#include <cstdint>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/runtime/external_program.h"
#include "tests/app/commands/run_isolux.h"
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

// An empty PATH: no gnuplot, and quick.
json study(const fs::path& folder, const std::vector<std::string>& arguments,
           const std::string& skipped = "") {
  std::vector<std::string> words{"study", "--out", "d", "--repeat", "1"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const RunResult result = runIsolux(words, {.folder = folder, .environment = {"PATH=/nonexistent"}});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(
      result.err,
      "isolux: note: no plots: they need gnuplot, which was not found (Debian: gnuplot-nox)\n" +
          (skipped.empty() ? "" : "isolux: note: not studied (reasons in study.md): " + skipped + '\n'));
  EXPECT_THAT(filesIn(folder / "d"), ElementsAre("study.json", "study.md"));
  return json::parse(contentOf(folder / "d" / "study.json"));
}

const json& settingOf(const json& study, std::size_t quality, const char* value) {
  for (const json& setting : study["knobs"][quality]["settings"])
    if (setting["value"] == value) return setting;
  throw std::out_of_range(value);
}

void expectLight(const json& setting, const std::string& name) {
  for (const char* cost : {"texels", "lattice_bytes", "gpu_bytes", "lookup_milliseconds"})
    EXPECT_GT(setting["light"][cost], 0) << name << ' ' << cost;
  EXPECT_EQ(setting["light"]["bake_seconds"].is_null(), setting["light"]["rays"] == 0) << name;
  const json& errors = setting["errors"];
  EXPECT_GT(errors["pixels"], 500) << name;
  for (const char* error : {"mean_irradiance", "truth_noise", "rmse", "rmse_standard_error",
                            "bias_standard_error", "quantile_99"})
    EXPECT_GT(errors[error], 0.0) << name << ' ' << error;
  for (const char* error : {"rmse_relative", "bias", "bias_relative", "maximum", "maximum_z"})
    EXPECT_TRUE(errors[error].is_number()) << name << ' ' << error;
  EXPECT_EQ(errors["maximum_pixel"].size(), 2u) << name;
}

void expectScale(const json& scale, const std::string& name) {
  EXPECT_GT(scale["points"], 100) << name;
  EXPECT_EQ(scale["build_seconds"] > 0.0, scale["scale_mm"] > 0.0) << name;
  for (const char* error : {"curvature_median_relative", "curvature_99_relative", "normal_rms_degrees"})
    EXPECT_GT(scale[error], 0.0) << name << ' ' << error;
  EXPECT_GE(scale["unknown_share"], 0.0) << name;
  EXPECT_LT(scale["unknown_share"], 1.0) << name;
}

TEST(StudyCommandGl, WritesEveryKnobWithUnitsMachineAndScene) {
  const fs::path folder = test::temporaryFolder();
  const json result = study(folder,
                            {"phantom:gyroid:32", "--size", "48x48", "--set", "gi.samples=4", "--set",
                             "light.environment.constant=1,1,1"},
                            "environment_share, sh_order, sh_window, components, component_bits");
  for (const char* key : {"isolux_study", "version", "complete", "machine", "context", "gl", "volume", "size",
                          "repeat", "units", "knobs", "scene"})
    EXPECT_TRUE(result.contains(key)) << key;
  EXPECT_EQ(result["complete"], true);
  EXPECT_EQ(result["volume"]["data_hash"].get<std::string>().size(), 16u);
  ASSERT_EQ(result["knobs"].size(), 23u);
  for (const json& quality : result["knobs"]) {
    if (quality.contains("skipped")) {
      EXPECT_THAT(quality["skipped"].get<std::string>(), HasSubstr("constant"));
      EXPECT_TRUE(quality["settings"].empty());
      continue;
    }
    int defaults = 0;
    for (const json& setting : quality["settings"]) {
      const std::string name = quality["name"].get<std::string>() + " " + setting["value"].get<std::string>();
      defaults += setting["default"] == true;
      EXPECT_GT(setting["frame_milliseconds"], 0.0) << name;
      EXPECT_LE(setting["frame_milliseconds_quartiles"][0], setting["frame_milliseconds"]) << name;
      EXPECT_GE(setting["picture"]["flip_mean"], 0.0) << name;
      EXPECT_LT(setting["picture"]["flip_mean"], 0.8) << name;
      EXPECT_EQ(setting["picture"]["flip_mean"] == 0.0, setting["picture"]["rms"] == 0.0) << name;
      EXPECT_EQ(setting["default"], name == quality["name"].get<std::string>() + " exact hits" ||
                                        (!quality["settings"].back()["comparison"].get<bool>() &&
                                         setting["setting_default"] == true))
          << name;
      if (quality.contains("truth")) {
        expectLight(setting, name);
        continue;
      }
      if (quality["name"] == "supersampling" || quality["name"] == "shadow") {
        EXPECT_GT(setting["pass_milliseconds"].value("cast", 0.0), 0.0) << name;
        continue;
      }
      for (const char* pass : {"cast", "gradient", "hessian"})
        EXPECT_GT(setting["pass_milliseconds"].value(pass, 0.0), 0.0) << name << ' ' << pass;
      if (setting.contains("scale")) {
        expectScale(setting["scale"], name);
        continue;
      }
      EXPECT_GT(setting["errors"]["surface_pixels"], 1000) << name;
      for (const char* error : {"depth_voxels", "depth_mm", "normal_degrees", "curvature_relative"})
        EXPECT_GT(setting["errors"][error]["pixels"], 100) << name << ' ' << error;
    }
    EXPECT_EQ(defaults, 1) << quality["name"];
    EXPECT_EQ(quality["reach"].size(), 3u);
    EXPECT_THAT(quality["advice"].get<std::string>(), testing::EndsWith(".")) << quality["name"];
  }
  const std::string text = contentOf(folder / "d" / "study.md");
  EXPECT_THAT(text, HasSubstr("| **exact hits** (default) |"));
  EXPECT_THAT(text, HasSubstr("## derivatives_field (`derivatives.field`)"));
  EXPECT_THAT(text, HasSubstr("Not studied: the environment is constant"));
  EXPECT_THAT(text, HasSubstr("| `gi.samples` |"));
}

struct Rmse {
  double square = 0.0, standardError = 0.0;  // of the mean square error
};
Rmse rmseOf(const json& setting) {
  const double rmse = setting["errors"]["rmse"].get<double>();
  const double upper = rmse + setting["errors"]["rmse_standard_error"].get<double>();
  return {rmse * rmse, upper * upper - rmse * rmse};
}
// In standard errors of the difference.
double worseBy(const json& a, const json& b) {
  const Rmse first = rmseOf(a), second = rmseOf(b);
  return (first.square - second.square) / std::hypot(first.standardError, second.standardError);
}

// A ball is convex: under an even sky E is pi at every pixel, whatever the setting. What is left are the 5
// and 6 bits of r11g11b10, of a number between 2 and 4: at most 2 / 64 / 2 for red and green, 2 / 32 / 2 for
// blue.
TEST(StudyCommandGl, AConvexBodyUnderAnEvenSkyHasNoError) {
  const json result = study(test::temporaryFolder(),
                            {"phantom:ball:32", "--size", "32x32", "--knobs", "samples,bounces,precision",
                             "--set", "light.environment.constant=1,1,1", "--set", "hit.field=cubic", "--set",
                             "isosurface.albedo=0.5,0.5,0.5"});
  for (const json& quality : result["knobs"])
    for (const json& setting : quality["settings"]) {
      const json& errors = setting["errors"];
      EXPECT_NEAR(errors["mean_irradiance"].get<double>(), M_PI, 1e-4) << setting["value"];
      EXPECT_LE(std::abs(errors["maximum"].get<double>()), 1.0 / 32.0) << setting["value"];
    }
  const json& half = settingOf(result, 2, "half");
  EXPECT_LE(std::abs(half["errors"]["maximum"].get<double>()), 2e-3);
}

// In a gyroid, which hides most of the sky from itself.
TEST(StudyCommandGl, LightBecomesBetterByWhatMakesItBetter) {
  // Trilinear: the weighted lookup takes out noise, which is what tells sequences apart.
  const json result =
      study(test::temporaryFolder(),
            {"phantom:gyroid:32", "--size", "64x64", "--knobs", "samples,sequence,bounces,interpolation",
             "--set", "gi.interpolation=trilinear", "--set", "light.environment.constant=1,1,1"});
  EXPECT_GT(worseBy(settingOf(result, 0, "4"), settingOf(result, 0, "64")), 4.5);
  EXPECT_GT(worseBy(settingOf(result, 1, "random"), settingOf(result, 1, "sobol_owen")), 4.5);
  EXPECT_GT(worseBy(settingOf(result, 3, "nearest"), settingOf(result, 3, "trilinear")), 4.5);
  // Every bounce adds light: those that are left out are a bias, and eight leave little of it.
  double before = -1e9;
  for (const char* bounces : {"0", "1", "2", "4"}) {
    const json& errors = settingOf(result, 2, bounces)["errors"];
    const double bias = errors["bias"].get<double>();
    EXPECT_LT(bias, -4.5 * errors["bias_standard_error"].get<double>()) << bounces;
    EXPECT_GT(bias, before) << bounces;
    before = bias;
  }
  EXPECT_EQ(result["knobs"][2]["truth"]["bounces"], 64);
  EXPECT_EQ(result["knobs"][0]["truth"]["bounces"], 1);
  const auto rays = [&](const char* samples) { return settingOf(result, 0, samples)["light"]["rays"]; };
  EXPECT_GT(rays("64"), 10 * rays("4").get<std::uint64_t>());
}

// The order of what is known: exact hits miss nothing, coarse ones do; a step of regula falsi is worth more
// than none; the errors of arithmetic are small beside those of a field.
TEST(StudyCommandGl, TheErrorsAreThoseOfTheSettings) {
  const json result =
      study(test::temporaryFolder(), {"phantom:noise:32", "--size", "48x48", "--knobs",
                                      "rate,refinements,method,hit_field,derivatives_field", "--set",
                                      "derivatives.scale=0", "--set", "derivatives.normal_scale=0"});
  const auto missed = [](const json& setting) { return setting["errors"]["missed_pixels"].get<int>(); };
  const auto depth = [](const json& errors) { return errors["depth_voxels"]["rms"].get<double>(); };
  EXPECT_EQ(missed(settingOf(result, 2, "exact")), 0);
  EXPECT_EQ(settingOf(result, 2, "exact")["errors"]["invented_pixels"], 0);
  EXPECT_LT(depth(settingOf(result, 2, "exact")["errors"]), 1e-3);
  EXPECT_EQ(missed(settingOf(result, 0, "exact hits")), 0);
  EXPECT_GT(missed(settingOf(result, 0, "0.5")), 0);
  EXPECT_GE(missed(settingOf(result, 0, "0.5")), missed(settingOf(result, 0, "16")));
  EXPECT_GT(depth(settingOf(result, 1, "0")["errors"]), 4.0 * depth(settingOf(result, 1, "4")["errors"]));

  const json& trilinear = settingOf(result, 3, "trilinear");
  EXPECT_GT(depth(trilinear["field_errors"]), 100.0 * depth(trilinear["errors"]));
  const json& interpolating = settingOf(result, 4, "cubic_interpolating");
  EXPECT_EQ(interpolating["errors"], interpolating["field_errors"]);
  const json& cubic = settingOf(result, 4, "cubic");
  EXPECT_GT(cubic["field_errors"]["normal_degrees"]["rms"], 1.0);
  EXPECT_LT(cubic["errors"]["normal_degrees"]["rms"], 0.1);
}

// The derivatives of the picture that the user has: at its own scales, where the fields hardly differ.
TEST(StudyCommandGl, TheSceneIsMeasuredAsItIs) {
  const json result =
      study(test::temporaryFolder(),
            {"phantom:noise:32", "--size", "48x48", "--knobs", "derivatives_field,fetch", "--set",
             "derivatives.scale=3", "--set", "derivatives.normal_scale=2", "--view", "+x"},
            "fetch");
  EXPECT_EQ(result["knobs"][0]["scales_mm"]["normals"], 2.0);
  EXPECT_EQ(result["knobs"][0]["scales_mm"]["curvature"], 3.0);
  EXPECT_LT(settingOf(result, 0, "cubic")["field_errors"]["normal_degrees"]["rms"], 0.5);
  EXPECT_LT(settingOf(result, 0, "cubic")["errors"]["normal_degrees"]["rms"], 0.1);
  EXPECT_GT(settingOf(result, 0, "cubic")["processor_milliseconds"], 0.0);
  EXPECT_THAT(result["knobs"][1]["skipped"].get<std::string>(), HasSubstr("at a scale"));
  EXPECT_GT(result["wall_per_processor_time"], 0.0);
  const json target = result["scene"]["camera"]["target"], eye = result["scene"]["camera"]["eye"];
  EXPECT_GT(eye[0], target[0]);
  EXPECT_NEAR(eye[1].get<double>(), target[1].get<double>(), 1e-9);
}

// More rays are nearer to very many; a shadow is seen, and its pass runs.
TEST(StudyCommandGl, EdgesAndShadowsAreJudgedByThePicture) {
  const json result = study(test::temporaryFolder(),
                            {"phantom:gyroid:32", "--size", "64x64", "--knobs", "supersampling,shadow",
                             "--set", "light.direction=-1,1,0.4", "--set", "light.setup=key"});
  double before = 1.0, flipBefore = 1.0;
  for (const char* rays : {"1", "2", "4"}) {
    const json& picture = settingOf(result, 0, rays)["picture"];
    EXPECT_GT(picture["edge_pixels"], 50) << rays;
    EXPECT_LT(picture["edge_pixels"], 64 * 64) << rays;
    EXPECT_GT(picture["edge_rms"], picture["rms"]) << rays;
    EXPECT_LT(picture["edge_rms"], 0.75 * before) << rays;
    EXPECT_LT(picture["flip_mean"], flipBefore) << rays;
    before = picture["edge_rms"];
    flipBefore = picture["flip_mean"];
  }
  EXPECT_EQ(settingOf(result, 1, "1")["picture"]["flip_mean"], 0.0);
  EXPECT_GT(settingOf(result, 1, "0")["picture"]["flip_mean"], 0.01);
  EXPECT_GT(settingOf(result, 1, "1")["pass_milliseconds"].value("shadow", 0.0), 0.0);
  EXPECT_FALSE(settingOf(result, 1, "0")["pass_milliseconds"].contains("shadow"));
}

TEST(StudyCommandGl, PlotsWhenGnuplotIsThere) {
  if (findProgram("gnuplot").empty()) GTEST_SKIP() << "no gnuplot";
  const fs::path folder = test::temporaryFolder();
  const RunResult result = runIsolux({"study", "phantom:ball:16", "--size", "24x24", "--repeat", "1",
                                      "--knobs", "rate,hit_field,fetch", "--out", "it's 100%"},
                                     {.folder = folder});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(filesIn(folder / "it's 100%"),
              ElementsAre("fetch.svg", "hit_field.svg", "rate.svg", "study.json", "study.md"));
  for (const char* label : {"Sampling rate", "samples per voxel", "exact hits", "default",
                            "time of cast + refine, ms", "missed pixels"})
    EXPECT_THAT(contentOf(folder / "it's 100%" / "rate.svg"), HasSubstr(label));
  EXPECT_THAT(contentOf(folder / "it's 100%" / "study.md"), HasSubstr("](rate.svg)"));
}

TEST(StudyCommandGl, AnInterruptLeavesTheFinishedKnobs) {
  const fs::path folder = test::temporaryFolder(), file = folder / "d" / "study.json";
  test::RunningIsolux running(
      {"study", "phantom:gyroid:32", "--size", "48x48", "--out", "d", "--repeat", "60"},
      {.folder = folder, .environment = {"PATH=/nonexistent"}});
  ASSERT_TRUE(test::pollUntil([&] { return fs::exists(file); }));
  running.signal(SIGINT);
  const RunResult result = running.wait();
  EXPECT_EQ(result.exitCode, 130);
  EXPECT_TRUE(result.isOneErrorLine()) << result.err;
  EXPECT_THAT(filesIn(folder / "d"), ElementsAre("study.json", "study.md"));
  const json left = json::parse(contentOf(file));
  EXPECT_EQ(left["complete"], false);
  ASSERT_GE(left["knobs"].size(), 1u);
  EXPECT_EQ(left["knobs"][0]["name"], "rate");
  EXPECT_EQ(left["knobs"][0]["settings"].size(), 7u);
  EXPECT_THAT(contentOf(folder / "d" / "study.md"), HasSubstr("Not complete"));
}

TEST(StudyCommandGl, AViewWithoutSurfaceIsRefused) {
  const fs::path folder = test::temporaryFolder();
  const RunResult result =
      runIsolux({"study", "phantom:ball:16", "--isovalue", "1e6", "--out", "d"}, {.folder = folder});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_TRUE(result.isOneErrorLine()) << result.err;
  EXPECT_THAT(result.err, HasSubstr("no pixel"));
}

}  // namespace
}  // namespace isolux::app
