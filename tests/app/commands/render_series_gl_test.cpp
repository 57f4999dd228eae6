// Runs `isolux render` for several pictures, with cameras by name and presets.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "app/documents/command_text.h"
#include "app/documents/session.h"
#include "app/runtime/external_program.h"
#include "scene/camera.h"
#include "tests/app/commands/run_isolux.h"
#include "tests/support/png_reader.h"
#include "tests/support/test_data.h"

namespace isolux::app {
namespace {

namespace fs = std::filesystem;
using test::contentOf;
using test::filesIn;
using test::runIsolux;
using test::RunResult;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

RunResult renderIn(const fs::path& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"render", "--size", "48x36"});
  return runIsolux(arguments, {.folder = folder});
}

glm::dvec3 sideOfEye(const fs::path& picture) {
  const scene::Camera camera = loadSession(picture).camera;
  return glm::normalize(camera.eye.value() - camera.target.value());
}

TEST(RenderSeriesGl, SeveralVolumesGoIntoFilesOfTheirNames) {
  const fs::path folder = test::temporaryFolder();
  const RunResult result = renderIn(
      folder, {"phantom:torus:16", "phantom:ball:16", "--out", "{n}_{name}.png", "--stats", "{name}.json"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(filesIn(folder), ElementsAre("1_torus.png", "2_ball.png", "ball.json", "torus.json"));
  // Each is what it is when drawn alone.
  EXPECT_EQ(renderIn(folder, {"phantom:ball:16", "--out", "alone.png"}).exitCode, 0);
  EXPECT_EQ(contentOf(folder / "alone.png"), contentOf(folder / "2_ball.png"));
}

TEST(RenderSeriesGl, TwoPicturesForOneFileAreRefusedBeforeAnyWork) {
  const fs::path folder = test::temporaryFolder();
  for (const std::vector<std::string>& line :
       {std::vector<std::string>{"phantom:torus:16", "phantom:ball:16", "--out", "a.png"},
        {"phantom:torus:16", "--out", "{name}.png", "--sweep", "look.fog=0:1:3", "--stats", "s.json"},
        {"phantom:torus:16", "phantom:ball:16", "--out", "-"},
        {"phantom:torus:16", "--out", "-", "--explain"},
        {"phantom:torus:16", "--out", "a.png", "--view", "above"},
        {"phantom:torus:16", "--out", "a.png", "--shift", "3"},
        {"phantom:torus:16", "--out", "a.png", "--preset", "ct_bonn"},
        {"phantom:torus:16", "--out", "a.png", "--preset", "ct_bone"},
        {"phantom:torus:16", "--out", "a.png", "--sweep", "look.fog=0:1:2", "--turntable", "3"}}) {
    const RunResult result = renderIn(folder, line);
    EXPECT_EQ(result.exitCode, 2) << testing::PrintToString(line);
    EXPECT_TRUE(result.isOneErrorLine()) << result.err;
    EXPECT_THAT(filesIn(folder), IsEmpty());
  }
}

TEST(RenderSeriesGl, ASweepDrawsEachValueFromOneCamera) {
  const fs::path folder = test::temporaryFolder();
  const RunResult result = renderIn(folder, {"phantom:ball:24", "--sweep", "isosurface.value=-2:2:3", "--fit",
                                             "surface", "--out", "b_{value}.png"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(filesIn(folder), ElementsAre("b_-2.png", "b_0.png", "b_2.png"));
  const scene::Scene first = loadSession(folder / "b_-2.png"), last = loadSession(folder / "b_2.png");
  EXPECT_EQ(first.surfaces.front().value, -2.0);
  EXPECT_EQ(last.surfaces.front().value, 2.0);
  EXPECT_EQ(first.camera, last.camera);
  // The same as drawn alone from its session.
  EXPECT_EQ(renderIn(folder, {"b_0.png", "--out", "again.png"}).exitCode, 0);
  EXPECT_EQ(contentOf(folder / "again.png"), contentOf(folder / "b_0.png"));
}

TEST(RenderSeriesGl, ASweepOfTheSourceReadsAVolumeForEachPicture) {
  const fs::path folder = test::temporaryFolder();
  const std::vector<std::string> blend{"phantom:ball:24", "--set", "source.csg=blend", "--set",
                                       "source.csg_path=phantom:torus"};
  const auto render = [&](std::vector<std::string> more) {
    more.insert(more.begin(), blend.begin(), blend.end());
    return renderIn(folder, more);
  };
  const RunResult result = render({"--sweep", "source.csg_weight=0:1:3", "--out", "b_{value}.png"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(filesIn(folder), ElementsAre("b_0.5.png", "b_0.png", "b_1.png"));
  EXPECT_NE(contentOf(folder / "b_0.png"), contentOf(folder / "b_1.png"));
  for (const char* picture : {"b_0.png", "b_0.5.png", "b_1.png"}) {
    EXPECT_EQ(renderIn(folder, {picture, "--out", "alone.png"}).exitCode, 0);
    EXPECT_EQ(contentOf(folder / "alone.png"), contentOf(folder / picture)) << picture;
  }
}

// Balls that grow, one file for each of three steps.
void writeSteps(const fs::path& folder) {
  for (int step = 0; step < 3; ++step) {
    std::ofstream file(folder / ("ball_" + std::to_string(step) + ".nrrd"), std::ios::binary);
    file << "NRRD0004\ntype: uint8\nencoding: raw\ndimension: 3\nsizes: 16 16 16\n\n";
    for (int i = 0; i < 16 * 16 * 16; ++i) {
      const glm::dvec3 at(i % 16, i / 16 % 16, i / 256);
      file.put(static_cast<char>(std::max(0.0, 90.0 - 10.0 * glm::length(at - 7.5) + 15.0 * step)));
    }
  }
}

TEST(RenderSeriesGl, AFilmOfTimeStepsHasThePictureOfEachStep) {
  const fs::path folder = test::temporaryFolder();
  writeSteps(folder);
  const auto render = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"ball_*.nrrd", "--set", "look.shading=gi", "--set", "gi.samples=4"});
    return renderIn(folder, more);
  };
  const RunResult result = render({"--sweep", "source.time_step=0:2:5", "--out", "f_{value}.png"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const scene::Scene first = loadSession(folder / "f_0.png");
  std::set<std::string> different;
  for (const char* step : {"0", "0.5", "1", "1.5", "2"}) {
    const fs::path picture = folder / ("f_" + std::string(step) + ".png");
    const scene::Scene scene = loadSession(picture);
    EXPECT_EQ(scene.camera, first.camera);
    EXPECT_EQ(scene.surfaces.front().value, first.surfaces.front().value) << "that of the first step";
    EXPECT_EQ(scene.source.path, first.source.path);
    EXPECT_EQ(renderIn(folder, {picture.string(), "--out", "alone.png"}).exitCode, 0);
    EXPECT_EQ(contentOf(folder / "alone.png"), contentOf(picture)) << step;
    different.insert(contentOf(picture));
  }
  EXPECT_EQ(different.size(), 5u);
  const RunResult beyond = render({"--sweep", "source.time_step=0:3:4", "--out", "g_{value}.png"});
  EXPECT_EQ(beyond.exitCode, 2);
  EXPECT_THAT(beyond.err, HasSubstr("time step 3 does not exist; the file has 3"));
}

TEST(RenderSeriesGl, TheFilesOfAFilmAreNotOverwritten) {
  const fs::path folder = test::temporaryFolder();
  writeSteps(folder);
  fs::rename(folder / "ball_1.nrrd", folder / "ball_1.png");
  const RunResult result = renderIn(folder, {"ball_0.nrrd;ball_1.png;ball_2.nrrd", "--out", "ball_1.png"});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.err, HasSubstr("would be written over the volume"));
}

// A film as a job array: each run draws some of the pictures.
TEST(RenderSeriesGl, FramesInPartsAreThoseOfOneRun) {
  const fs::path whole = test::temporaryFolder(), parts = test::temporaryFolder();
  const auto turn = [](const fs::path& folder, std::vector<std::string> more) {
    more.insert(more.begin(), {"phantom:torus:16", "--turntable", "5", "--out", "turn"});
    return renderIn(folder, more);
  };
  EXPECT_EQ(turn(whole, {}).exitCode, 0);
  EXPECT_EQ(turn(parts, {"--frames", "3-9"}).exitCode, 0);
  EXPECT_THAT(filesIn(parts / "turn"), ElementsAre("frame_00003.png", "frame_00004.png"));
  EXPECT_EQ(turn(parts, {"--frames", "1"}).exitCode, 0);
  EXPECT_THAT(filesIn(parts / "turn"), ElementsAre("frame_00001.png", "frame_00003.png", "frame_00004.png"));
  // What is there is left as it is, whatever it is.
  std::ofstream(parts / "turn" / "frame_00003.png") << "kept";
  EXPECT_EQ(turn(parts, {"--skip-existing"}).exitCode, 0);
  EXPECT_EQ(contentOf(parts / "turn" / "frame_00003.png"), "kept");
  fs::remove(parts / "turn" / "frame_00003.png");
  EXPECT_EQ(turn(parts, {"--skip-existing"}).exitCode, 0);
  for (const char* name :
       {"frame_00000.png", "frame_00001.png", "frame_00002.png", "frame_00003.png", "frame_00004.png"})
    EXPECT_EQ(contentOf(parts / "turn" / name), contentOf(whole / "turn" / name)) << name;
}

TEST(RenderSeriesGl, FramesThatAreNoneAreRefused) {
  const fs::path folder = test::temporaryFolder();
  for (const char* frames : {"5", "5-7", "2-1", "-1", "1-", "a", "1-2-3", "", "99999999999"}) {
    const RunResult result =
        renderIn(folder, {"phantom:torus:16", "--turntable", "5", "--out", "turn", "--frames", frames});
    EXPECT_EQ(result.exitCode, 2) << frames;
    EXPECT_TRUE(result.isOneErrorLine()) << result.err;
    EXPECT_THAT(filesIn(folder), IsEmpty()) << frames;
  }
  EXPECT_EQ(renderIn(folder, {"phantom:torus:16", "--out", "a.png", "--frames", "0"}).exitCode, 2);
  EXPECT_EQ(renderIn(folder, {"phantom:torus:16", "--turntable", "5", "--out", "turn", "--frames", "0",
                              "--time", "50ms"})
                .exitCode,
            2);
}

TEST(RenderSeriesGl, ATurntableGoesRoundOnceAndMakesAMovie) {
  const fs::path folder = test::temporaryFolder();
  const RunResult result = renderIn(folder, {"phantom:torus:16", "--turntable", "4", "--out", "turn"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  std::vector<std::string> expected{"frame_00000.png", "frame_00001.png", "frame_00002.png",
                                    "frame_00003.png"};
  if (!findProgram("ffmpeg").empty() && result.err.find("no movie.mp4") == std::string::npos)
    expected.emplace_back("movie.mp4");
  EXPECT_EQ(filesIn(folder / "turn"), expected);
  const glm::dvec3 front = sideOfEye(folder / "turn" / "frame_00000.png"),
                   quarter = sideOfEye(folder / "turn" / "frame_00001.png"),
                   half = sideOfEye(folder / "turn" / "frame_00002.png");
  // About +z, counterclockwise from above: from the front (-y) to +x.
  EXPECT_NEAR(quarter.x, -front.y, 1e-9);
  EXPECT_NEAR(half.y, -front.y, 1e-9);
  EXPECT_NEAR(half.z, front.z, 1e-9);
}

TEST(RenderSeriesGl, StandardOutputHasThePictureAndNothingElse) {
  const fs::path folder = test::temporaryFolder();
  EXPECT_EQ(renderIn(folder, {"phantom:torus:16", "--out", "a.png"}).exitCode, 0);
  const RunResult result = renderIn(folder, {"phantom:torus:16", "--out", "-"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.out, contentOf(folder / "a.png"));
  EXPECT_THAT(filesIn(folder), ElementsAre("a.png"));
}

TEST(RenderSeriesGl, ViewsByNameStandOnTheirSide) {
  const fs::path folder = test::temporaryFolder();
  const auto side = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"phantom:ball:16", "--out", "v.png"});
    EXPECT_EQ(renderIn(folder, words).exitCode, 0);
    return sideOfEye(folder / "v.png");
  };
  EXPECT_NEAR(side({"--view", "left"}).x, 1.0, 1e-9);
  EXPECT_NEAR(side({"--view", "+z"}).z, 1.0, 1e-9);
  EXPECT_NEAR(side({"--view", "anterior", "--azimuth", "90"}).x, 1.0, 1e-9);
  EXPECT_NEAR(side({"--view", "anterior", "--elevation", "90"}).z, 1.0, 1e-9);
}

TEST(RenderSeriesGl, RollTurnsThePictureClockwiseAndUpIsSaidOnce) {
  const fs::path folder = test::temporaryFolder();
  ASSERT_EQ(
      renderIn(folder, {"phantom:ball:16", "--view", "anterior", "--roll", "90", "--out", "v.png"}).exitCode,
      0);
  const scene::Camera camera = loadSession(folder / "v.png").camera;
  const scene::CameraFrame frame = scene::frameOf(camera);
  EXPECT_NEAR(std::abs(frame.right.z), 1.0, 1e-9) << "what was up lies at a side";
  EXPECT_GT(frame.right.z, 0.0) << "at the right of a picture that has turned clockwise is what was up";
  const auto refused = renderIn(
      folder, {"phantom:ball:16", "--view", "anterior", "--set", "camera.up=1,0,0", "--out", "w.png"});
  EXPECT_EQ(refused.exitCode, 2);
  EXPECT_TRUE(refused.isOneErrorLine()) << refused.err;
}

TEST(RenderSeriesGl, FitSurfaceFillsThePictureAndZoomGoesNearer) {
  const fs::path folder = test::temporaryFolder();
  const auto distance = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"phantom:ball:32", "--isovalue", "6", "--out", "v.png"});
    EXPECT_EQ(renderIn(folder, words).exitCode, 0);
    const scene::Camera camera = loadSession(folder / "v.png").camera;
    return glm::length(camera.eye.value() - camera.target.value());
  };
  const double volume = distance({"--fit", "volume"}), surface = distance({"--fit", "surface"});
  EXPECT_LT(surface, 0.8 * volume);
  EXPECT_NEAR(distance({"--fit", "surface", "--zoom", "2"}), surface / 2.0, 1e-9 * surface);
  // The ball ends within the picture, and near its border.
  const RunResult hit = renderIn(
      folder, {"phantom:ball:32", "--isovalue", "6", "--fit", "surface", "--set", "look.background_top=0,0,0",
               "--set", "look.background_bottom=0,0,0", "--set", "look.mode=normal", "--out", "n.png"});
  EXPECT_EQ(hit.exitCode, 0);
  const render::ColorImage image = test::readPng(folder / "n.png");
  int top = image.size.y, bottom = -1;
  for (int y = 0; y < image.size.y; ++y)
    for (int x = 0; x < image.size.x; ++x) {
      const std::uint8_t* const p = &image.rgba[static_cast<std::size_t>(4 * (y * image.size.x + x))];
      if (p[0] + p[1] + p[2] < 60) continue;
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  EXPECT_GE(top, 0);
  EXPECT_LE(top, 2);
  EXPECT_GE(bottom, image.size.y - 3);
}

TEST(RenderSeriesGl, APresetIsRecordedAsOrdinarySettings) {
  const fs::path folder = test::temporaryFolder();
  const RunResult result =
      renderIn(folder, {"phantom:head:32", "--preset", "ct_metal", "--shift", "-700", "--out", "p.png"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const scene::Scene scene = loadSession(folder / "p.png");
  EXPECT_TRUE(scene.surfaces.at(1).shown);
  EXPECT_EQ(renderIn(folder, {"p.png", "--out", "again.png"}).exitCode, 0);
  EXPECT_EQ(contentOf(folder / "again.png"), contentOf(folder / "p.png"));
}

TEST(RenderSeriesGl, ACommandMadeOfASceneDrawsItBitForBit) {
  const fs::path folder = test::temporaryFolder();
  const RunResult made =
      renderIn(folder, {"phantom:two_balls:24", "--look", "kappa1", "--set",
                        "look.range_high=0.1234567890123", "--set", "pieces.hidden=-1.5,0.25,3; 4,5,6",
                        "--set", "look.curvature_points=[[0.1,-0.2,0.3,0.4,0.5],[1,1,0,0,0],[-1,-1,1,1,1]]",
                        "--set", "isosurface.opacity=0.7", "--set", "look.legend=false", "--azimuth", "33",
                        "--out", "it's a.png"});
  ASSERT_EQ(made.exitCode, 0) << made.err;
  const scene::Scene scene = loadSession(folder / "it's a.png");
  const std::string line = renderCommand(scene, {}, {48, 36}, "the other's.png");
  // The shell takes the line apart, as it would a pasted one.
  const fs::path binary(ISOLUX_BINARY);
  std::ofstream(folder / "run.sh") << "cd " << shellWord(folder.string())
                                   << "\nPATH=" << shellWord(binary.parent_path().string()) << ":$PATH\n"
                                   << line << '\n';
  ASSERT_EQ(std::system(("sh " + shellWord((folder / "run.sh").string())).c_str()), 0) << line;
  EXPECT_EQ(test::readPng(folder / "it's a.png").rgba, test::readPng(folder / "the other's.png").rgba)
      << line;
  EXPECT_EQ(loadSession(folder / "the other's.png"), scene);
}

TEST(CommandText, WordsAreQuotedForAShell) {
  EXPECT_EQ(shellWord("a/b-c.nii.gz"), "a/b-c.nii.gz");
  EXPECT_EQ(shellWord(""), "''");
  EXPECT_EQ(shellWord("a b"), "'a b'");
  EXPECT_EQ(shellWord("it's"), "'it'\\''s'");
  EXPECT_EQ(shellWord("$(rm)"), "'$(rm)'");
  EXPECT_EQ(shellWord("~x"), "'~x'");
}

}  // namespace
}  // namespace isolux::app
