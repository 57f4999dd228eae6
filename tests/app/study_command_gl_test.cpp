// Runs `isolux study`: needs a graphics context, software is enough.
#include <chrono>
#include <csignal>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/external_program.h"
#include "tests/app/run_isolux.h"
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
json study(const fs::path& folder, const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"study", "--out", "d", "--repeat", "1"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const RunResult result = runIsolux(words, {.folder = folder, .environment = {"PATH=/nonexistent"}});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.err,
            "isolux: note: no plots: they need gnuplot, which was not found (Debian: gnuplot-nox)\n");
  EXPECT_THAT(filesIn(folder / "d"), ElementsAre("study.json", "study.md"));
  return json::parse(contentOf(folder / "d" / "study.json"));
}

const json& settingOf(const json& study, std::size_t knob, const std::string& value) {
  for (const json& setting : study["knobs"][knob]["settings"])
    if (setting["value"] == value) return setting;
  throw std::out_of_range(value);
}

TEST(StudyCommandGl, WritesEveryKnobWithUnitsMachineAndScene) {
  const fs::path folder = test::temporaryFolder();
  const json result = study(folder, {"phantom:gyroid:32", "--size", "48x48"});
  for (const char* key : {"isolux_study", "version", "complete", "machine", "context", "gl", "volume", "size",
                          "repeat", "units", "knobs", "scene"})
    EXPECT_TRUE(result.contains(key)) << key;
  EXPECT_EQ(result["complete"], true);
  EXPECT_EQ(result["volume"]["data_hash"].get<std::string>().size(), 16u);
  ASSERT_EQ(result["knobs"].size(), 8u);
  for (const json& knob : result["knobs"]) {
    int defaults = 0;
    for (const json& setting : knob["settings"]) {
      const std::string name = knob["name"].get<std::string>() + " " + setting["value"].get<std::string>();
      defaults += setting["default"] == true;
      EXPECT_GT(setting["frame_milliseconds"], 0.0) << name;
      for (const char* pass : {"cast", "gradient", "hessian"})
        EXPECT_GT(setting["pass_milliseconds"].value(pass, 0.0), 0.0) << name << ' ' << pass;
      EXPECT_GT(setting["errors"]["surface_pixels"], 1000) << name;
      for (const char* error : {"depth_voxels", "depth_mm", "normal_degrees", "curvature_relative"})
        EXPECT_GT(setting["errors"][error]["pixels"], 100) << name << ' ' << error;
    }
    EXPECT_EQ(defaults, 1) << knob["name"];
    EXPECT_EQ(knob["reach"].size(), 3u);
  }
  const std::string text = contentOf(folder / "d" / "study.md");
  EXPECT_THAT(text, HasSubstr("| **2** (default) |"));
  EXPECT_THAT(text, HasSubstr("## derivatives_field (`derivatives.field`)"));
}

// The order of what is known: exact hits miss nothing, coarse ones do; a step of regula falsi is worth more
// than none; the errors of arithmetic are small beside those of a field.
TEST(StudyCommandGl, TheErrorsAreThoseOfTheSettings) {
  const json result = study(test::temporaryFolder(), {"phantom:noise:32", "--size", "48x48", "--knobs",
                                                      "rate,refinements,method,hit_field,derivatives_field"});
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
  for (const char* label : {"hit.rate of", "samples per voxel", "exact hits", "default",
                            "time of cast + refine, ms", "missed pixels"})
    EXPECT_THAT(contentOf(folder / "it's 100%" / "rate.svg"), HasSubstr(label));
  EXPECT_THAT(contentOf(folder / "it's 100%" / "study.md"), HasSubstr("](rate.svg)"));
}

TEST(StudyCommandGl, AnInterruptLeavesTheFinishedKnobs) {
  const fs::path folder = test::temporaryFolder(), file = folder / "d" / "study.json";
  test::RunningIsolux running(
      {"study", "phantom:gyroid:32", "--size", "48x48", "--out", "d", "--repeat", "60"},
      {.folder = folder, .environment = {"PATH=/nonexistent"}});
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!fs::exists(file) && std::chrono::steady_clock::now() < deadline)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
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
