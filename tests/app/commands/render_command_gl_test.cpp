// Runs `isolux render` and `isolux replay`: these need a graphics context, software is enough.
#include <cmath>
#include <fstream>

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/documents/recording.h"
#include "app/documents/session.h"
#include "app/files/image_io.h"
#include "app/runtime/external_program.h"
#include "tests/app/commands/run_isolux.h"
#include "tests/support/png_reader.h"
#include "tests/support/test_data.h"

namespace isolux::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::contentOf;
using test::filesIn;
using test::runIsolux;
using test::RunResult;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

void succeed(const std::vector<std::string>& arguments, const fs::path& folder) {
  const RunResult result = runIsolux(arguments, {.folder = folder});
  EXPECT_EQ(result.exitCode, 0) << testing::PrintToString(arguments) << '\n' << result.err;
}

TEST(RenderCommandGl, APictureCarriesTheSessionThatMakesItAgain) {
  const fs::path folder = test::temporaryFolder();
  succeed({"render", "phantom:torus:24", "--size", "80x60", "--look", "lambert", "--isovalue", "-0.5",
           "--out", "a.png"},
          folder);
  succeed({"render", "a.png", "--size", "80x60", "--out", "b.png"}, folder);
  EXPECT_EQ(contentOf(folder / "a.png"), contentOf(folder / "b.png"));
  const scene::Scene scene = loadSession(folder / "a.png");
  EXPECT_EQ(scene.surfaces.front().value, -0.5);
  EXPECT_TRUE(scene.camera.eye) << "the same view even if automatic choices change";

  saveSession(scene, folder / "s.isolux");
  succeed({"render", "s.isolux", "--size", "80x60", "--out", "c.png"}, folder);
  EXPECT_EQ(contentOf(folder / "a.png"), contentOf(folder / "c.png"));
  succeed({"render", "a.png", "--set", "look.mode=normal", "--size", "80x60", "--out", "d.png"}, folder);
  EXPECT_NE(test::readPng(folder / "a.png").rgba, test::readPng(folder / "d.png").rgba);
  EXPECT_EQ(test::readPng(folder / "d.png").size, glm::ivec2(80, 60));
  EXPECT_THAT(filesIn(folder), ElementsAre("a.png", "b.png", "c.png", "d.png", "s.isolux"));
}

// Whoever opens it finds one isosurface, and everything automatic that nobody chose.
TEST(RenderCommandGl, APictureCarriesWhatWasChosenAndNoMore) {
  const fs::path folder = test::temporaryFolder();
  succeed({"render", "phantom:torus:24", "--size", "40x30", "--look", "kappa1", "--out", "a.png"}, folder);
  const scene::Scene scene = loadSession(folder / "a.png");
  EXPECT_TRUE(scene.surfaces.front().value);
  EXPECT_TRUE(scene.camera.eye);
  EXPECT_EQ(scene.surfaces.size(), 1U) << "a surface that nobody made";
  EXPECT_FALSE(scene.derivatives.scale);
  EXPECT_FALSE(scene.derivatives.noise);
  succeed(
      {"render", "phantom:torus:24", "--size", "40x30", "--set", "isosurface2.shown=true", "--out", "b.png"},
      folder);
  EXPECT_TRUE(loadSession(folder / "b.png").surfaces.at(1).value) << "is shown";
}

TEST(RenderCommandGl, AovsAreNamedFloatChannelsWithNanWhereNothingIsHit) {
  const fs::path folder = test::temporaryFolder();
  succeed({"render", "phantom:ball:32", "--size", "41x41", "--aov", "position,depth,value_error,hit", "--set",
           "camera.frames=volume", "--out", "a.exr"},
          folder);
  const auto input = OIIO::ImageInput::open((folder / "a.exr").string());
  ASSERT_TRUE(input);
  const OIIO::ImageSpec& spec = input->spec();
  EXPECT_THAT(spec.channelnames, testing::UnorderedElementsAre("position.x", "position.y", "position.z",
                                                               "depth", "value_error", "hit"));
  std::vector<float> values(41 * 41 * 6);
  ASSERT_TRUE(input->read_image(0, 0, 0, 6, OIIO::TypeDesc::FLOAT, values.data()));
  const auto at = [&](int x, int y, const char* channel) {
    return values[static_cast<std::size_t>((y * 41 + x) * 6 + spec.channelindex(channel))];
  };
  EXPECT_EQ(at(0, 0, "hit"), 0.0f);
  EXPECT_TRUE(std::isnan(at(0, 0, "position.x")) && std::isnan(at(0, 0, "depth")));
  EXPECT_EQ(at(20, 20, "hit"), 1.0f);
  EXPECT_NEAR(at(20, 20, "position.x"), 0.0f, 0.05f) << "the ball's middle, in the middle of the picture";
  EXPECT_LT(at(20, 20, "position.y"), -1.0f) << "seen from the front";
  EXPECT_LT(at(20, 20, "value_error"), 0.01f);
}

TEST(RenderCommandGl, AnExrOfColoursIsLinear) {
  const fs::path folder = test::temporaryFolder();
  succeed({"render", "phantom:ball:16", "--size", "16x12", "--out", "a.exr"}, folder);
  const auto input = OIIO::ImageInput::open((folder / "a.exr").string());
  ASSERT_TRUE(input);
  EXPECT_THAT(input->spec().channelnames, ElementsAre("R", "G", "B"));
  // The background is the mix of its two linear colours to the last digits of a float: not dithered, and not
  // of 256 steps.
  succeed({"render", "phantom:ball:16", "--size", "16x12", "--out", "b.exr", "--set",
           "look.background_top=0.9,0.125,0.3", "--set", "look.background_bottom=0.1,0.375,0.1", "--set",
           "isosurface.value=5000"},
          folder);
  const auto background = OIIO::ImageInput::open((folder / "b.exr").string());
  ASSERT_TRUE(background);
  std::vector<float> pixels(16 * 12 * 3);
  ASSERT_TRUE(background->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, pixels.data()));
  const double low = (5.0 + 0.5) / 12.0;  // of the height, in the middle of the seventh row from the top
  for (std::size_t x = 0; x < 16; ++x) {
    const float* const pixel = &pixels[(6 * 16 + x) * 3];
    EXPECT_NEAR(pixel[0], 0.1 + 0.8 * low, 1e-6);
    EXPECT_NEAR(pixel[1], 0.375 - 0.25 * low, 1e-6);
    EXPECT_NEAR(pixel[2], 0.1 + 0.2 * low, 1e-6);
  }
}

TEST(RenderCommandGl, AnEmptyPictureIsSaidOnStderrAndInTheStats) {
  const fs::path folder = test::temporaryFolder();
  const auto result = runIsolux({"render", "phantom:ball:16", "--size", "16x12", "--out", "a.png", "--stats",
                                 "s.json", "--isovalue", "9999"},
                                {.folder = folder});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_NE(result.err.find("isolux: note: the image is empty: No surface at 9999"), std::string::npos)
      << result.err;
  EXPECT_TRUE(json::parse(contentOf(folder / "s.json"))["empty"].is_string());
  succeed({"render", "phantom:ball:16", "--size", "16x12", "--out", "b.png", "--stats", "s.json"}, folder);
  EXPECT_TRUE(json::parse(contentOf(folder / "s.json"))["empty"].is_null());
}

TEST(RenderCommandGl, StatsHaveTheDocumentedKeys) {
  const fs::path folder = test::temporaryFolder();
  succeed({"render", "phantom:ball:32", "--size", "40x30", "--out", "a.png", "--stats", "s.json", "--repeat",
           "2"},
          folder);
  const json stats = json::parse(contentOf(folder / "s.json"));
  for (const char* key : {"version", "context", "gl", "size", "supersampling", "isovalue", "passes",
                          "frame_milliseconds", "repeat", "blocks", "programs", "image_bytes", "gpu_bytes",
                          "peak_bytes", "parts", "data_hash", "read_seconds", "prepare_seconds"})
    EXPECT_TRUE(stats.contains(key)) << key;
  ASSERT_FALSE(stats["passes"].empty());
  bool ran = false;
  for (const json& pass : stats["passes"]) {
    for (const char* key : {"name", "state", "reason", "milliseconds"})
      EXPECT_TRUE(pass.contains(key)) << key;
    ran = ran || pass["state"] == "ran";
  }
  EXPECT_TRUE(ran) << "a measured frame runs its passes again";
  EXPECT_GT(stats["frame_milliseconds"], 0.0);
  EXPECT_GT(stats["blocks"]["active"], 0);
  EXPECT_LT(stats["blocks"]["active"], stats["blocks"]["total"]);
  EXPECT_GT(stats["peak_bytes"], 1000000);
  const json info = json::parse(runIsolux({"info", "phantom:ball:32", "--json"}).out);
  EXPECT_EQ(stats["data_hash"], info["data_hash"]);
}

TEST(RenderCommandGl, ExplainPrintsThePasses) {
  const RunResult result =
      runIsolux({"render", "phantom:ball:16", "--size", "8x8", "--out", "a.png", "--explain"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.out,
              AllOf(HasSubstr("pass"), HasSubstr("state"), HasSubstr("reason"), HasSubstr("ran")));
}

TEST(RenderCommandGl, NoContextIsExit4) {
  const fs::path folder = test::temporaryFolder();
  const RunResult result =
      runIsolux({"render", "phantom:ball:8", "--out", "a.png", "--context", "egl"},
                {.folder = folder, .environment = {"__EGL_VENDOR_LIBRARY_DIRS=/nonexistent"}});
  EXPECT_EQ(result.exitCode, 4);
  EXPECT_TRUE(result.isOneErrorLine()) << result.err;
  EXPECT_THAT(filesIn(folder), IsEmpty());
}

// A second of a turn, a new isovalue and another volume.
void writeRecording(const fs::path& file) {
  scene::Scene start;
  start.source.path = "phantom:ball:16";
  Recorder recorder(file, start);
  recorder.add({"Rotate", {{"camera.eye", {60.0, -60.0, 10.0}}}}, 0.2);
  recorder.add({"Set isovalue", {{"isosurface.value", -2.0}}}, 0.3);
  recorder.add({"Open", {{"source.path", "phantom:torus:16"}}}, 0.5);
}

TEST(ReplayCommandGl, ReplayingTwiceGivesIdenticalFrames) {
  const fs::path folder = test::temporaryFolder();
  writeRecording(folder / "r.jsonl");
  for (const char* out : {"one", "two"})
    succeed({"replay", "r.jsonl", "--out", out, "--fps", "10", "--size", "45x35"}, folder);
  std::vector<std::string> frames;
  for (const std::string& name : filesIn(folder / "one"))
    if (name != "movie.mp4") frames.push_back(name);
  EXPECT_THAT(frames, ElementsAre("frame_00000.png", "frame_00001.png", "frame_00002.png", "frame_00003.png",
                                  "frame_00004.png", "frame_00005.png"));
  for (const std::string& name : frames)
    EXPECT_EQ(contentOf(folder / "one" / name), contentOf(folder / "two" / name)) << name;

  const auto pixels = [&](int frame) {
    return test::readPng(folder / "one" / frames.at(static_cast<std::size_t>(frame))).rgba;
  };
  EXPECT_EQ(pixels(0), pixels(1));
  EXPECT_NE(pixels(1), pixels(2)) << "a change at 0.2 s is in frame 2";
  EXPECT_NE(pixels(2), pixels(3));
  EXPECT_EQ(pixels(3), pixels(4));
  EXPECT_NE(pixels(4), pixels(5)) << "the last change is in the last frame";
}

TEST(ReplayCommandGl, AnAnimatedFlowRunsOnFromFrameToFrame) {
  const fs::path folder = test::temporaryFolder();
  {
    scene::Scene start;
    start.source.path = "phantom:torus:16";
    start.look.mode = scene::LookMode::flow;
    start.flow.time = 2.0;
    Recorder recorder(folder / "r.jsonl", start);
    recorder.add({"Animate", {{"flow.animate", true}}}, 0.1);
    recorder.add({"Zoom", {{"camera.fov", 40.0}}}, 0.4);
  }
  succeed({"replay", "r.jsonl", "--out", "frames", "--fps", "10", "--size", "45x35"}, folder);
  std::vector<double> times;
  for (int frame = 0; frame < 5; ++frame)
    times.push_back(
        loadSession(folder / "frames" / ("frame_0000" + std::to_string(frame) + ".png")).flow.time);
  EXPECT_THAT(times, testing::Pointwise(testing::DoubleNear(1e-12), {2.0, 2.0, 2.1, 2.2, 2.3}));
  EXPECT_NE(test::readPng(folder / "frames" / "frame_00002.png").rgba,
            test::readPng(folder / "frames" / "frame_00003.png").rgba)
      << "the streaks move though nothing was changed";
}

TEST(ReplayCommandGl, AFrameIsThePictureOfItsSession) {
  const fs::path folder = test::temporaryFolder();
  writeRecording(folder / "r.jsonl");
  succeed({"replay", "r.jsonl", "--out", "frames", "--fps", "10", "--size", "40x30"}, folder);
  succeed({"render", "frames/frame_00003.png", "--size", "40x30", "--out", "a.png"}, folder);
  EXPECT_EQ(test::readPng(folder / "a.png").rgba, test::readPng(folder / "frames" / "frame_00003.png").rgba);
}

TEST(ReplayCommandGl, MakesAMovieWhenFfmpegWorks) {
  if (findProgram("ffmpeg").empty()) GTEST_SKIP() << "no ffmpeg";
  const fs::path folder = test::temporaryFolder();
  writeRecording(folder / "r.jsonl");
  succeed({"replay", "r.jsonl", "--out", "100%d", "--fps", "10", "--size", "33x21"}, folder);
  EXPECT_GT(fs::file_size(folder / "100%d" / "movie.mp4"), 500u);
}

TEST(ReplayCommandGl, AFailingFfmpegIsOnlyANote) {
  const fs::path folder = test::temporaryFolder();
  writeRecording(folder / "r.jsonl");
  fs::create_directories(folder / "bin");
  std::ofstream(folder / "bin" / "ffmpeg")
      << "#!/bin/sh\necho half > .movie.mp4.part\necho no such codec >&2\nexit 3\n";
  fs::permissions(folder / "bin" / "ffmpeg", fs::perms::owner_all);
  const auto replay = [&](const std::string& path, const char* out) {
    return runIsolux({"replay", (folder / "r.jsonl").string(), "--out", (folder / out).string(), "--fps", "2",
                      "--size", "8x8"},
                     {.environment = {"PATH=" + path}});
  };
  const RunResult failing = replay((folder / "bin").string(), "a");
  EXPECT_EQ(failing.exitCode, 0);
  EXPECT_THAT(failing.err, AllOf(HasSubstr("isolux: note: "), HasSubstr("no such codec")));
  EXPECT_FALSE(fs::exists(folder / "a" / "movie.mp4"));
  const RunResult missing = replay("/nonexistent", "b");
  EXPECT_EQ(missing.exitCode, 0);
  EXPECT_THAT(missing.err, HasSubstr("ffmpeg was not found"));
  EXPECT_THAT(filesIn(folder / "b"), ElementsAre("frame_00000.png", "frame_00001.png"));
}

TEST(ReplayCommandGl, RefusesEndlessRecordings) {
  const fs::path folder = test::temporaryFolder();
  std::ofstream(folder / "r.jsonl") << "{\"isolux_recording\": 1}\n{\"time\": 999999, \"set\": {}}\n";
  const RunResult result = runIsolux({"replay", "r.jsonl", "--out", "d"}, {.folder = folder});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_TRUE(result.isOneErrorLine());
  EXPECT_FALSE(fs::exists(folder / "d"));
}

TEST(RenderCommandGl, APictureThatDoesNotFitIsRefusedWithWhatLowersIt) {
  const fs::path folder = test::temporaryFolder();
  const RunResult result = runIsolux({"render", "phantom:ball:16", "--size", "8192x8192", "--memory-budget",
                                      "100M", "--context", "software", "--out", "a.png"},
                                     {.folder = folder});
  EXPECT_EQ(result.exitCode, 5) << result.err;
  EXPECT_TRUE(result.isOneErrorLine());
  EXPECT_THAT(result.err, AllOf(HasSubstr("a smaller image"), HasSubstr("memory budget of 100.0 MiB")));
  EXPECT_THAT(filesIn(folder), IsEmpty());
}

TEST(RenderCommandGl, AnAxisOfMoreThan4096VoxelsIsDrawn) {
  const fs::path folder = test::temporaryFolder();
  // A wall at x = 4990 of 5000 voxels.
  std::string voxels(5000 * 4 * 4, '\0');
  for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = i % 5000 >= 4990 ? '\xc8' : '\0';
  std::ofstream(folder / "long.raw", std::ios::binary) << voxels;
  succeed({"render", "long.raw", "--raw", "5000x4x4 uint8", "--isovalue", "100", "--size", "31x31",
           "--camera", "4900,1.5,1.5 4990,1.5,1.5 0,0,1 1", "--aov", "voxel,hit", "--out", "a.exr"},
          folder);
  const auto input = OIIO::ImageInput::open((folder / "a.exr").string());
  ASSERT_TRUE(input);
  const OIIO::ImageSpec& spec = input->spec();
  std::vector<float> pixels(static_cast<std::size_t>(31 * 31 * spec.nchannels));
  ASSERT_TRUE(input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data()));
  const auto centre = static_cast<std::size_t>((15 * 31 + 15) * spec.nchannels);
  const int x = spec.channelindex("voxel.x"), hit = spec.channelindex("hit");
  ASSERT_GE(hit, 0);
  ASSERT_GE(x, 0);
  EXPECT_EQ(pixels[centre + static_cast<std::size_t>(hit)], 1.0f);
  EXPECT_NEAR(pixels[centre + static_cast<std::size_t>(x)], 4989.5f, 1e-2f);
}

TEST(RenderCommandGl, AnAxisBeyondTheDriverIsRefusedWithTheSizeThatWorks) {
  const fs::path folder = test::temporaryFolder();
  std::ofstream(folder / "long.raw", std::ios::binary) << std::string(65535 * 4, '\0');
  const RunResult result = runIsolux({"render", "long.raw", "--raw", "65535x2x2 uint8", "--size", "32x32",
                                      "--isovalue", "1", "--context", "software", "--out", "a.png"},
                                     {.folder = folder});
  if (result.exitCode == 0) return;  // a driver with large 3D textures
  EXPECT_EQ(result.exitCode, 5);
  EXPECT_THAT(result.err, AllOf(HasSubstr("cannot be drawn with this driver"), HasSubstr("takes up to")));
}

}  // namespace
}  // namespace isolux::app
