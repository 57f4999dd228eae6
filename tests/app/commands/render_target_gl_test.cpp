// Runs `isolux render --error` and `--time`: needs a graphics context, software is enough.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/documents/session.h"
#include "app/files/image_io.h"
#include "tests/app/commands/run_isolux.h"
#include "tests/support/test_data.h"

namespace isolux::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::callIsolux;
using test::contentOf;
using test::filesIn;
using test::runIsolux;
using test::RunResult;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<std::string> render(std::vector<std::string> more) {
  std::vector<std::string> words{"render", "phantom:gyroid:32", "--size", "96x72", "--executor", "gpu"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(RenderTargetGl, TheChoiceIsExplainedAndItsPictureIsMadeAgainBySession) {
  const fs::path folder = test::temporaryFolder();
  const RunResult result = runIsolux(render({"--error", "depth=0.2vox,missed=3%,light=2%", "--explain",
                                             "--stats", "s.json", "--out", "a.png"}),
                                     {.folder = folder});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("note: --error: light is ignored: this image reads no baked light\n"));
  EXPECT_THAT(
      result.out,
      HasSubstr(
          "chosen because it is the least work that keeps depth at most 0.2 voxels, missed at most 3 %"));
  const json target = json::parse(contentOf(folder / "s.json")).at("target");
  const json& settings = target["chosen"]["settings"];
  EXPECT_EQ(settings["hit.method"], "sampled");
  EXPECT_LE(target["expected_error"]["depth_voxels"]["at_most"], 0.2);
  EXPECT_GT(target["expected_milliseconds"], 0.0);
  EXPECT_GT(target["alternatives"].size(), 1u);
  EXPECT_EQ(target["limits"].size(), 2u);

  const scene::Scene scene = loadSession(folder / "a.png");
  EXPECT_EQ(scene.hit.method, scene::HitMethod::sampled);
  ASSERT_EQ(
      runIsolux({"render", "a.png", "--executor", "gpu", "--out", "b.png"}, {.folder = folder}).exitCode, 0);
  EXPECT_EQ(contentOf(folder / "a.png"), contentOf(folder / "b.png"));
}

TEST(RenderTargetGl, WithoutTheOptionsNothingIsSearched) {
  const fs::path folder = test::temporaryFolder();
  const RunResult result =
      runIsolux(render({"--explain", "--stats", "s.json", "--out", "a.png"}), {.folder = folder});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_FALSE(json::parse(contentOf(folder / "s.json")).contains("target"));
  EXPECT_THAT(result.out, Not(HasSubstr("chosen because")));
  EXPECT_EQ(loadSession(folder / "a.png").hit.method, scene::HitMethod::exact);
}

TEST(RenderTargetGl, WhatIsSetStaysAndATimeIsKept) {
  const fs::path folder = test::temporaryFolder();
  const RunResult result = runIsolux(
      render({"--time", "100s", "--set", "hit.method=sampled", "--stats", "s.json", "--out", "a.png"}),
      {.folder = folder});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(loadSession(folder / "a.png").hit.method, scene::HitMethod::sampled);
  const json target = json::parse(contentOf(folder / "s.json")).at("target");
  EXPECT_LE(target["expected_milliseconds"], 1e5);
}

TEST(RenderTargetGl, WhatIsWrongIsOneLineAndLeavesNoPicture) {
  const fs::path folder = test::temporaryFolder();
  const auto refused = [&](const std::vector<std::string>& more, const char* why) {
    const RunResult result = callIsolux(render(more), folder);
    EXPECT_EQ(result.exitCode, 2) << why;
    EXPECT_THAT(result.err, HasSubstr(why));
    EXPECT_TRUE(result.isOneErrorLine()) << result.err;
  };
  refused({"--error", "dept=1mm", "--out", "a.png"}, "did you mean depth?");
  refused({"--time", "soon", "--out", "a.png"}, "is not a time");
  refused({"--error", "depth=1mm", "--time", "1s", "--out", "a.png"}, "--error");
  refused({"--error", "depth=1e-12mm", "--out", "a.png"}, "the smallest guaranteed error is depth");
  refused({"--error", "depth=1mm", "--set", "clip.box=-9,-9,-9;9,9,9", "--out", "a.png"}, "knows no cuts");
  EXPECT_THAT(filesIn(folder), IsEmpty());
}

}  // namespace
}  // namespace isolux::app
