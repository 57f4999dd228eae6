#include "app/documents/recording.h"

#include <csignal>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "base/error.h"
#include "scene/settings/scene_diff.h"
#include "tests/app/commands/run_isolux.h"
#include "tests/support/paths.h"
#include "tests/support/test_data.h"

namespace isolux::app {
namespace {

namespace fs = std::filesystem;
using scene::Scene;
using scene::SceneDiff;
using testing::AllOf;
using testing::HasSubstr;

std::string refusal(const std::string& text) {
  const fs::path file = test::temporaryFolder() / "r.jsonl";
  std::ofstream(file, std::ios::binary) << text;
  try {
    loadRecording(file);
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::input);
    EXPECT_EQ(error.file(), file.string());
    return error.what();
  }
  ADD_FAILURE() << "accepted: " << text;
  return {};
}

TEST(Recording, OfEveryVersionIsReadToItsEnd) {
  std::size_t found = 0;
  const fs::path folder = fs::path(ISOLUX_SOURCE_DIR) / "tests/app/same_picture/recordings";
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path().filename());
    const Recording recording = loadRecording(entry.path());
    EXPECT_GE(recording.steps.size(), 3u);
    Playback playback(recording);
    EXPECT_NE(playback.at(recording.duration()), recording.start);
    ++found;
  }
  EXPECT_GE(found, 8u);
}

TEST(Recording, RoundTrips) {
  const fs::path folder = test::temporaryFolder();
  Scene start;
  start.source.path = (folder / "ct.nii").string();
  start.camera.fov = 1.0 / 3.0 + 20;
  const SceneDiff first{"Rotate", {{"camera.eye", {1.0 / 3.0, -2.5, 1e-9}}}};
  const SceneDiff second{"Open",
                         {{"isosurface.value", "auto"}, {"source.path", (folder / "b.nii").string()}}};
  {
    Recorder recorder(folder / "r.jsonl", start);
    recorder.add(first, 0.25);
    recorder.add(SceneDiff{"Nothing", {}}, 0.3);
    recorder.add(second, 1.5);
  }
  const Recording recording = loadRecording(folder / "r.jsonl");
  EXPECT_TRUE(recording.start == start);
  ASSERT_EQ(recording.steps.size(), 2u);
  EXPECT_EQ(recording.steps[0].seconds, 0.25);
  EXPECT_EQ(recording.steps[0].diff, first);
  EXPECT_EQ(recording.steps[1].diff, second);
  EXPECT_EQ(recording.duration(), 1.5);

  EXPECT_TRUE(Playback(recording).at(0.2) == start);
  EXPECT_TRUE(Playback(recording).at(0.25) == scene::applied(start, first));
  EXPECT_TRUE(Playback(recording).at(9) == scene::applied(scene::applied(start, first), second));
}

TEST(Recording, OfBeforeBuiltInLightsKeepsItsSkyAndItsExposure) {
  const fs::path file = test::temporaryFolder() / "r.jsonl";
  std::ofstream(file) << "{\"isolux_recording\": 1, \"scene\": {\"look\": {\"mode\": \"gi\"}}}\n"
                         "{\"time\": 1, \"set\": {\"light.environment.constant\": [0.5, 1, 2]}}\n";
  const Recording recording = loadRecording(file);
  EXPECT_EQ(recording.start.light.environment.constant, glm::dvec3(1.0));
  EXPECT_EQ(recording.start.picture.metering, scene::Metering::lights);
  EXPECT_EQ(Playback(recording).at(2).light.environment.constant, glm::dvec3(0.5, 1.0, 2.0));
  std::ofstream(file) << "{\"isolux_recording\": 2}\n";
  EXPECT_FALSE(loadRecording(file).start.light.environment.constant);
}

TEST(Recording, OfBeforeScalesKeepsItsDerivatives) {
  const fs::path file = test::temporaryFolder() / "r.jsonl";
  for (const char* version : {"1", "2"}) {
    std::ofstream(file) << "{\"isolux_recording\": " << version << "}\n";
    const Scene start = loadRecording(file).start;
    EXPECT_EQ(start.derivatives.scale, 0.0);
    EXPECT_EQ(start.derivatives.normalScale, 0.0);
    EXPECT_EQ(start.picture.restHits, scene::StillField::same);
  }
  std::ofstream(file) << "{\"isolux_recording\": 3}\n";
  const Scene third = loadRecording(file).start;
  EXPECT_EQ(third.derivatives.scale, std::nullopt);
  EXPECT_EQ(third.camera.frames, scene::Frames::volume) << "its automatic camera stays where it was";
  EXPECT_EQ(third.isosurface.suggestion, scene::Suggestion::contrast);
  std::ofstream(file) << "{\"isolux_recording\": 4}\n";
  EXPECT_EQ(loadRecording(file).start.light.setup, scene::LightSetup::key);
  EXPECT_EQ(loadRecording(file).start.camera.frames, scene::Frames::surface);
  std::ofstream(file) << "{\"isolux_recording\": 5}\n";
  EXPECT_EQ(loadRecording(file).start.picture.curve, scene::ToneCurve::linear);
  std::ofstream(file) << "{\"isolux_recording\": 6}\n";
  EXPECT_EQ(loadRecording(file).start.source.labels, "values");
  std::ofstream(file) << "{\"isolux_recording\": 7}\n";
  EXPECT_TRUE(loadRecording(file).start == Scene{});
  EXPECT_THAT(refusal("{\"isolux_recording\": 8}\n"), HasSubstr("versions 1 to 7"));
}

TEST(Recording, AnAnimatedFlowMovesOn) {
  Recording recording;
  recording.start.look.mode = scene::LookMode::flow;
  recording.start.flow.time = 1.0;
  recording.steps = {{0.5, {"Animate", {{"flow.animate", true}}}},
                     {2.0, {"Rotate", {{"camera.fov", 40.0}}}},
                     {3.0, {"Pause", {{"flow.animate", false}, {"flow.time", 3.5}}}}};
  EXPECT_EQ(Playback(recording).at(0.4).flow.time, 1.0);
  EXPECT_EQ(Playback(recording).at(0.75).flow.time, 1.25);
  EXPECT_EQ(Playback(recording).at(2.5).flow.time, 3.0);
  EXPECT_EQ(Playback(recording).at(9.0).flow.time, 3.5);
}

TEST(Recording, MovesWithItsFolder) {
  const fs::path folder = test::temporaryFolder();
  fs::create_directories(folder / "old");
  Scene start;
  start.source.path = (folder / "old" / "ct.nii").string();
  start.light.environment.file = (folder / "old" / "a.hdr").string();
  {
    Recorder recorder(folder / "old" / "r.jsonl", start);
    recorder.add({"Open", {{"source.path", (folder / "old" / "b.nii").string()}}}, 1);
    recorder.add({"Cut", {{"source.csg_path", (folder / "old" / "c.stl").string()}}}, 2);
    recorder.add({"Light", {{"light.environment.file", (folder / "old" / "b.hdr").string()}}}, 3);
  }
  fs::rename(folder / "old", folder / "new");
  const Recording recording = loadRecording(folder / "new" / "r.jsonl");
  EXPECT_EQ(recording.start.source.path, (folder / "new" / "ct.nii").string());
  EXPECT_EQ(Playback(recording).at(1).source.path, (folder / "new" / "b.nii").string());
  EXPECT_EQ(Playback(recording).at(2).source.csgPath, (folder / "new" / "c.stl").string());
  EXPECT_EQ(Playback(recording).at(2).light.environment.file, (folder / "new" / "a.hdr").string());
  EXPECT_EQ(Playback(recording).at(3).light.environment.file, (folder / "new" / "b.hdr").string());
}

TEST(Recording, EveryStepIsOnDiskAtOnce) {
  const fs::path file = test::temporaryFolder() / "r.jsonl";
  Recorder recorder(file, Scene{});
  EXPECT_TRUE(loadRecording(file).steps.empty());
  recorder.add({"Zoom", {{"camera.fov", 40.0}}});
  const Recording recording = loadRecording(file);
  ASSERT_EQ(recording.steps.size(), 1u);
  EXPECT_GE(recording.steps[0].seconds, 0.0);
  EXPECT_LT(recording.steps[0].seconds, 60.0);
}

TEST(Recording, AcceptsBlankLinesAndNoNameAndADefaultScene) {
  const fs::path file = test::temporaryFolder() / "r.jsonl";
  std::ofstream(file) << "{\"isolux_recording\": 7}\n\n{\"time\": 0, \"set\": {}}\r\n   \n";
  const Recording recording = loadRecording(file);
  EXPECT_TRUE(recording.start == Scene{});
  EXPECT_EQ(recording.steps.size(), 1u);
}

TEST(Recording, BadLinesAreNamed) {
  const std::string header = "{\"isolux_recording\": 1, \"scene\": {}}\n";
  EXPECT_THAT(refusal(""), HasSubstr("line 1"));
  EXPECT_THAT(refusal("{}\n"), AllOf(HasSubstr("line 1"), HasSubstr("not a recording")));
  EXPECT_THAT(refusal("nonsense\n"), AllOf(HasSubstr("line 1"), HasSubstr("JSON")));
  EXPECT_THAT(refusal("{\"isolux_recording\": 8}\n"), HasSubstr("versions 1 to 7"));
  EXPECT_THAT(refusal("{\"isolux_recording\": 1, \"scene\": {\"camera\": {\"fow\": 1}}}\n"),
              AllOf(HasSubstr("line 1"), HasSubstr("camera.fow")));
  EXPECT_THAT(refusal("{\"isolux_recording\": 1, \"extra\": 1}\n"), HasSubstr("extra"));
  EXPECT_THAT(refusal(header + "{\"time\": 1, \"set\": {}}\n{\"time\": 0.5, \"set\": {}}\n"),
              AllOf(HasSubstr("line 3"), HasSubstr("before")));
  EXPECT_THAT(refusal(header + "\n{\"time\": 1, \"set\": {\"camera.fow\": 1}}\n"),
              AllOf(HasSubstr("line 3"), HasSubstr("camera.fow")));
  EXPECT_THAT(refusal(header + "{\"time\": 1, \"set\": {\"camera.fov\": 1000}}\n"),
              AllOf(HasSubstr("line 2"), HasSubstr("camera.fov"), HasSubstr("160")));
  EXPECT_THAT(refusal(header + "{\"time\": 1, \"set\": {\"camera.fov\": 10}\n"), HasSubstr("line 2, column"))
      << "broken, and not by a cut: the line has its end";
  for (const char* time : {"-1", "\"1\"", "1e300", "null"})
    EXPECT_THAT(refusal(header + "{\"time\": " + time + ", \"set\": {}}\n"),
                AllOf(HasSubstr("line 2"), HasSubstr("time")));
  EXPECT_THAT(refusal(header + "{\"set\": {}}\n"), HasSubstr("time"));
  EXPECT_THAT(refusal(header + "{\"time\": 1}\n"), HasSubstr("set"));
  EXPECT_THAT(refusal(header + "{\"time\": 1, \"set\": {}, \"more\": 1}\n"),
              AllOf(HasSubstr("line 2"), HasSubstr("more")));
  EXPECT_THAT(refusal(header + "{\"time\": 1, \"set\": {}, \"name\": 1}\n"), HasSubstr("name"));
  EXPECT_THAT(refusal(header + "[]\n"), HasSubstr("line 2"));
}

TEST(Recording, ALastLineThatWasCutShortIsLeftOut) {
  const fs::path file = test::temporaryFolder() / "r.jsonl";
  const std::string header = "{\"isolux_recording\": 1, \"scene\": {}}\n";
  const std::string first = "{\"time\": 1, \"set\": {\"camera.fov\": 10}}\n";
  const std::string last = "{\"time\": 2, \"name\": \"Zoom\", \"set\": {\"camera.fov\": 20}}";
  for (std::size_t length = 0; length <= last.size(); ++length) {
    std::ofstream(file, std::ios::binary) << header << first << last.substr(0, length);
    const Recording recording = loadRecording(file);
    const bool whole = length == last.size();
    EXPECT_EQ(recording.steps.size(), whole ? 2u : 1u) << length;
    EXPECT_EQ(recording.warnings.size(), length == 0 || whole ? 0u : 1u) << length;
    if (!recording.warnings.empty()) {
      EXPECT_THAT(recording.warnings[0], HasSubstr("line 3"));
    }
  }
  std::ofstream(file, std::ios::binary) << header.substr(0, 20);
  EXPECT_THROW(loadRecording(file), base::Error) << "of a cut first line nothing can be shown";
}

TEST(Recording, WritesOverRecordingsOnly) {
  const fs::path folder = test::temporaryFolder();
  for (const char* content :
       {"NRRD0004\nsome voxels", "{\"isolux_session\": 2, \"scene\": {}}\n", "\n", "x"}) {
    const fs::path file = folder / "precious";
    std::ofstream(file, std::ios::binary) << content;
    EXPECT_THROW(Recorder(file, Scene{}), base::Error) << content;
    EXPECT_EQ(test::contentOf(file), content);
  }
  std::ofstream(folder / "empty").close();
  EXPECT_NO_THROW(Recorder(folder / "empty", Scene{}));
  EXPECT_NO_THROW(Recorder(folder / "empty", Scene{})) << "a recording by now";
  EXPECT_TRUE(isRecording(folder / "empty"));
  EXPECT_FALSE(isRecording(folder / "missing"));
  EXPECT_FALSE(isRecording(folder));
}

TEST(Recording, AFullDiskIsAnError) {
  const fs::path file = test::temporaryFolder() / "r.jsonl";
  Recorder recorder(file, Scene{});
  // A limit on the size of files stands for the disk.
  const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  rlimit little = before;
  little.rlim_cur = fs::file_size(file) + 20;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &little), 0);
  EXPECT_THROW(recorder.add({"Zoom", {{"camera.fov", 40.0}}}, 1), base::Error);
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, ignored);
  const Recording recording = loadRecording(file);  // what came before is whole
  EXPECT_TRUE(recording.start == Scene{});
  EXPECT_TRUE(recording.steps.empty());
}

TEST(Recording, MissingFilesAndFoldersAreErrors) {
  const fs::path folder = test::temporaryFolder();
  EXPECT_THROW(loadRecording(folder / "missing"), base::Error);
  EXPECT_THROW(loadRecording(folder), base::Error);
  EXPECT_THROW(Recorder(folder / "no" / "r.jsonl", Scene{}), base::Error);
}

}  // namespace
}  // namespace isolux::app
