// Pictures of volumes whose voxels stay in their file, and isolux index: the same pictures as from memory,
// and one line where that cannot be.
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/commands/run_isolux.h"
#include "tests/support/test_data.h"

namespace isolux::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class FileVoxelsGl : public testing::Test {
 protected:
  RunResult isolux(std::vector<std::string> arguments) { return callIsolux(arguments, folder_); }
  void makePhantom(const std::string& name, const std::string& size, const std::string& file) {
    const RunResult made = isolux({"phantom", name, "--size", size, "--out", file});
    ASSERT_EQ(made.exitCode, 0) << made.err;
  }
  // By shaders, of bricks in the smallest cache. An automatic camera frames the volume, as it can frame the
  // surface of voxels in memory only.
  RunResult render(const std::string& file, const std::string& out, const std::string& voxels,
                   const std::vector<std::string>& more = {}) {
    std::vector<std::string> all{"render", file, "--out", out, "--size", "200x160"};
    for (const char* set : {"picture.executor=gpu", "memory.layout=bricks", "memory.gpu_budget_mb=16",
                            "memory.ram_budget_mb=16", "derivatives.scale=0", "derivatives.normal_scale=0",
                            "derivatives.noise=0", "picture.rest_hits=same", "camera.frames=volume",
                            "isosurface.suggestion=contrast"})
      all.insert(all.end(), {"--set", set});
    all.insert(all.end(), {"--set", "memory.voxels=" + voxels});
    all.insert(all.end(), more.begin(), more.end());
    return isolux(all);
  }

  std::string bytesOf(const std::string& name) const { return contentOf(folder_ / name); }

  fs::path folder_ = temporaryFolder();
};

TEST_F(FileVoxelsGl, ThePictureIsThatFromMemoryByteForByte) {
  makePhantom("head", "96", "head.nrrd");
  makePhantom("gyroid", "100", "gyroid.mhd");
  for (const std::string name : {"head.nrrd", "gyroid.mhd"})
    for (const std::string look : {"blinn_phong", "mean_curvature", "normal"}) {
      SCOPED_TRACE(name + " " + look);
      // Their ends are chosen from curvatures all over the surface.
      const std::vector<std::string> more{
          "--look", look, "--set", "look.range_low=-0.1", "--set", "look.range_high=0.1"};
      const RunResult memory = render(name, "memory.png", "memory", more);
      const RunResult file = render(name, "file.png", "file", more);
      ASSERT_EQ(memory.exitCode, 0) << memory.err;
      ASSERT_EQ(file.exitCode, 0) << file.err;
      EXPECT_TRUE(bytesOf("memory.png") == bytesOf("file.png"));
    }
}

// The ball's surface lies in a small part of its volume.
TEST_F(FileVoxelsGl, StatisticsSayWhatWasRead) {
  makePhantom("ball", "256", "ball.nrrd");
  ASSERT_EQ(render("ball.nrrd", "a.png", "file", {"--stats", "file.json"}).exitCode, 0);
  const nlohmann::json stats = nlohmann::json::parse(bytesOf("file.json")), parts = stats["parts"];
  EXPECT_GT(parts["read"], 0);
  EXPECT_LE(parts["read"], stats["bricks"]["uploaded"]);
  EXPECT_GE(parts["file_bytes"], parts["bytes"]);
  EXPECT_LT(parts["file_bytes"], 256 * 256 * 256 * 2);
  EXPECT_LE(parts["kept_bytes"], parts["budget_bytes"]);
  EXPECT_LE(parts["budget_bytes"], 16 << 20);  // less the index
  EXPECT_GT(parts["budget_bytes"], 15 << 20);
  ASSERT_EQ(render("ball.nrrd", "a.png", "memory", {"--stats", "memory.json"}).exitCode, 0);
  EXPECT_TRUE(nlohmann::json::parse(bytesOf("memory.json"))["parts"].is_null());
}

// Whether a picture at rest gains from hits of a spline is measured of all voxels.
TEST_F(FileVoxelsGl, APictureAtRestHasTheHitsOfTheSamples) {
  makePhantom("wires", "64", "wires.nrrd");
  const RunResult drawn = isolux({"render", "wires.nrrd", "--out", "a.png", "--size", "100x80", "--stats",
                                  "a.json", "--set", "memory.voxels=file"});
  ASSERT_EQ(drawn.exitCode, 0) << drawn.err;
  EXPECT_EQ(nlohmann::json::parse(bytesOf("a.json"))["hits"]["field"], "trilinear");
}

TEST_F(FileVoxelsGl, WhatNeedsAllVoxelsIsRefusedInOneLine) {
  makePhantom("ball", "40", "ball.nrrd");
  const struct {
    std::vector<std::string> options;
    const char* says;
  } cases[] = {{{"--set", "hit.field=cubic"}, "hit.field=trilinear"},
               {{"--set", "picture.rest_hits=cubic_interpolating"}, "picture.rest_hits=same"},
               {{"--set", "derivatives.field=cubic_interpolating"}, "derivatives.field=cubic"},
               {{"--set", "derivatives.normal_scale=2"}, "derivatives.normal_scale=0"},
               {{"--look", "gi"}, "global illumination"},
               {{"--set", "pieces.keep=1"}, "pieces"},
               {{"--accuracy"}, "bounds of errors"}};
  for (const auto& one : cases) {
    const RunResult result = render("ball.nrrd", "out.png", "file", one.options);
    EXPECT_EQ(result.exitCode, 5) << result.err;
    EXPECT_TRUE(result.isOneErrorLine()) << result.err;
    EXPECT_THAT(result.err, HasSubstr(one.says));
    EXPECT_FALSE(fs::exists(folder_ / "out.png"));
  }
  const RunResult phantom = render("phantom:ball:40", "out.png", "file");
  EXPECT_EQ(phantom.exitCode, 3) << phantom.err;
  EXPECT_TRUE(phantom.isOneErrorLine()) << phantom.err;
}

TEST_F(FileVoxelsGl, AFileThatBecameShorterIsOneLine) {
  makePhantom("ball", "64", "ball.mhd");
  ASSERT_EQ(render("ball.mhd", "a.png", "file").exitCode, 0);
  // Of the same size and time, so that the index is still believed: bytes are missing on the way.
  const fs::path raw = folder_ / "ball.raw";
  ASSERT_TRUE(fs::exists(raw));
  fs::resize_file(raw, fs::file_size(raw) / 2);
  const RunResult cut = render("ball.mhd", "b.png", "file");
  EXPECT_EQ(cut.exitCode, 3) << cut.err;
  EXPECT_TRUE(cut.isOneErrorLine()) << cut.err;
  EXPECT_FALSE(fs::exists(folder_ / "b.png"));
  fs::remove(raw);
  const RunResult gone = render("ball.mhd", "b.png", "file");
  EXPECT_EQ(gone.exitCode, 3) << gone.err;
  EXPECT_TRUE(gone.isOneErrorLine()) << gone.err;
}

TEST_F(FileVoxelsGl, IndexInPartsAndAgain) {
  makePhantom("ball", "64", "ball.nrrd");
  EXPECT_EQ(isolux({"index", "ball.nrrd", "--part", "1/2"}).exitCode, 0);
  EXPECT_TRUE(fs::exists(folder_ / "ball.nrrd.index.part-1-of-2"));
  const RunResult whole = isolux({"index", "ball.nrrd"});
  EXPECT_EQ(whole.exitCode, 0) << whole.err;
  EXPECT_TRUE(fs::exists(folder_ / "ball.nrrd.index"));
  EXPECT_FALSE(fs::exists(folder_ / "ball.nrrd.index.part-1-of-2"));
  EXPECT_THAT(isolux({"index", "ball.nrrd"}).out, HasSubstr("up to date"));
  EXPECT_EQ(isolux({"index", "ball.nrrd", "--part", "3/2"}).exitCode, 2);
  const RunResult phantom = isolux({"index", "phantom:ball"});
  EXPECT_EQ(phantom.exitCode, 3);
  EXPECT_TRUE(phantom.isOneErrorLine()) << phantom.err;
}

}  // namespace
}  // namespace isolux::test
