#include "app/documents/session.h"

#include <cstdlib>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/documents/stored_scene.h"
#include "app/files/files.h"
#include "app/files/image_io.h"
#include "app/files/state_folder.h"
#include "base/error.h"
#include "tests/app/commands/run_isolux.h"
#include "tests/support/paths.h"
#include "tests/support/test_data.h"

namespace isolux::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using scene::Scene;
using testing::AllOf;
using testing::HasSubstr;

// A scene of before label maps had surfaces.
Scene labelledAsBefore() {
  Scene scene;
  scene.source.labels = "values";
  return scene;
}

// What a session of before looks had more than a key light leaves unsaid.
Scene shadedAsBefore() {
  Scene scene = labelledAsBefore();
  scene.light.setup = scene::LightSetup::key;
  scene.light.direction = {-0.5, 0.7, 0.9};
  scene.look.ambientVariation = 0.0;
  scene.picture.curve = scene::ToneCurve::linear;
  scene.picture.metering = scene::Metering::brightness;
  scene.light.environment.builtIn = scene::BuiltInLight::dark_studio;
  return scene;
}

// And of before automatic cameras framed the surface.
Scene firstSeenAsBefore() {
  Scene scene = shadedAsBefore();
  scene.camera.frames = scene::Frames::volume;
  scene.isosurface.suggestion = scene::Suggestion::contrast;
  return scene;
}

// And of before there were derivatives at a scale.
Scene derivedAsBefore() {
  Scene scene = firstSeenAsBefore();
  scene.derivatives.scale = scene.derivatives.normalScale = 0.0;
  scene.picture.restHits = scene::StillField::same;
  scene.look.contours = 0.0;
  scene.look.toneCool = {0.08, 0.12, 0.35};
  scene.look.toneWarm = {0.95, 0.72, 0.38};
  return scene;
}

// And of before there were built-in lights.
Scene litAsBefore() {
  Scene scene = derivedAsBefore();
  scene.light.environment.constant = glm::dvec3(1.0);
  scene.picture.metering = scene::Metering::lights;
  return scene;
}

Scene someScene() {
  Scene scene;
  scene.source.path = "phantom:torus:64";
  scene.surfaces.front().value = 1.0 / 3.0;
  scene.camera.eye = glm::dvec3(0.1, -400, 1e-7);
  scene.look.mode = scene::LookMode::normal;
  return scene;
}

void writeFile(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

std::string sessionRefusal(const std::string& text) {
  try {
    parseSession(text, "some.isolux", {"/data"});
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::input);
    EXPECT_EQ(error.file(), "some.isolux");
    return error.what();
  }
  ADD_FAILURE() << "accepted: " << text;
  return {};
}

TEST(Session, OfBeforeToneCurvesStaysLinear) {
  const auto read = [](const std::string& text) { return parseSession(text, "a.isolux", {"/data"}); };
  EXPECT_EQ(read(R"({"isolux_session": 8})").picture.curve, scene::ToneCurve::linear);
  EXPECT_EQ(read(R"({"isolux_session": 9})").picture.curve, scene::ToneCurve::automatic);
}

TEST(Session, OfBeforeBuiltInLightsKeepsItsSkyAndItsExposure) {
  const auto read = [](const std::string& text) { return parseSession(text, "a.isolux", {"/data"}); };
  const Scene bare = read(R"({"isolux_session": 3, "scene": {"look": {"mode": "gi"}}})");
  EXPECT_EQ(bare.light.environment.constant, glm::dvec3(1.0));
  EXPECT_EQ(bare.picture.metering, scene::Metering::lights);
  const Scene full = read(R"({"isolux_session": 3, "scene": {"picture": {"exposure": "auto"}, "light": {
      "environment": {"file": "/p.hdr", "constant": [0.5, 1, 2], "rotation": [0, 0, 0, 1]}}}})");
  EXPECT_EQ(full.light.environment.constant, glm::dvec3(0.5, 1.0, 2.0));
  EXPECT_EQ(full.light.environment.file, "/p.hdr");
  EXPECT_EQ(full.light.environment.rotation, glm::dvec4(0.0, 0.0, 0.0, 1.0));
  EXPECT_EQ(full.picture.metering, scene::Metering::lights);
  EXPECT_EQ(read(R"({"isolux_session": 1, "settings": {"look.mode": "gi"}})").light.environment.constant,
            glm::dvec3(1.0));
  EXPECT_EQ(read(R"({"isolux_session": 2})").picture.metering, scene::Metering::lights);
  EXPECT_TRUE(read(R"({"isolux_session": 4})") == derivedAsBefore()) << "later ones have the light of now";
  EXPECT_THAT(sessionRefusal(R"({"isolux_session": 3, "scene": {"light": 7}})"), HasSubstr("light"));
  EXPECT_THAT(sessionRefusal(R"({"isolux_session": 3, "scene": 7})"), HasSubstr("scene"));
}

TEST(Session, RoundTripsThroughAFile) {
  const fs::path folder = test::temporaryFolder();
  saveSession(someScene(), folder / "a.isolux");
  EXPECT_TRUE(loadSession(folder / "a.isolux") == someScene());
  EXPECT_TRUE(isSession(folder / "a.isolux"));
  saveSession(Scene{}, folder / "a.isolux");  // over an old one
  EXPECT_TRUE(loadSession(folder / "a.isolux") == Scene{});
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1)
      << "something was left behind";
}

TEST(Session, IsVersionedJson) {
  const json stored = json::parse(sessionText(someScene(), "/data"));
  EXPECT_EQ(stored["isolux_session"], 10);
  EXPECT_TRUE(stored["program"].is_string());
  EXPECT_EQ(stored["scene"]["look"]["mode"], "normal");
}

TEST(Session, PathsAreRelativeBelowTheFolderOnly) {
  Scene scene;
  const auto stored = [&](const char* path, const char* folder) {
    scene.source.path = path;
    return json::parse(sessionText(scene, folder))["scene"]["source"]["path"].get<std::string>();
  };
  EXPECT_EQ(stored("/data/ct.nii", "/data"), "ct.nii");
  EXPECT_EQ(stored("/data/ct.nii", "/data/"), "ct.nii");
  EXPECT_EQ(stored("/data/a/../b/ct.nii", "/data"), "b/ct.nii");
  EXPECT_EQ(stored("/other/ct.nii", "/data"), "/other/ct.nii");
  EXPECT_EQ(stored("/database/ct.nii", "/data"), "/database/ct.nii");
  EXPECT_EQ(stored("phantom:head", "/data"), "phantom:head");
  EXPECT_EQ(stored("/data/ünï.nii", "/data"), "ünï.nii");

  const auto parsed = [](const std::string& path, const char* folder) {
    return parseSession(json{{"isolux_session", 2}, {"scene", {{"source", {{"path", path}}}}}}.dump(), "x",
                        {folder})
        .source.path;
  };
  EXPECT_EQ(parsed("ct.nii", "/data"), "/data/ct.nii");
  EXPECT_EQ(parsed("../ct.nii", "/data/a"), "/data/ct.nii");
  EXPECT_EQ(parsed("/other/ct.nii", "/data"), "/other/ct.nii");
  EXPECT_EQ(parsed("phantom:ball:32", "/data"), "phantom:ball:32");
  EXPECT_EQ(parsed("ct.nii", ""), (fs::current_path() / "ct.nii").string()) << "absolute in memory";
}

TEST(Session, AMovedFolderStillFindsItsVolume) {
  const fs::path folder = test::temporaryFolder();
  fs::create_directories(folder / "old");
  Scene scene;
  scene.source.path = (folder / "old" / "ct.nii").string();
  scene.source.csgPath = (folder / "old" / "cut.stl").string();
  saveSession(scene, folder / "old" / "s.isolux");
  fs::rename(folder / "old", folder / "new");
  EXPECT_EQ(loadSession(folder / "new" / "s.isolux").source.path, (folder / "new" / "ct.nii").string());
  EXPECT_EQ(loadSession(folder / "new" / "s.isolux").source.csgPath, (folder / "new" / "cut.stl").string());
}

TEST(Session, FilesThatAreTimeStepsAreFoundWhereTheyAre) {
  const fs::path folder = test::temporaryFolder();
  for (const char* name : {"linked", "real"}) fs::create_directories(folder / name);
  for (const char* name : {"t_1.nrrd", "t_2.nrrd"}) writeTextFile(folder / "real" / name, "NRRD0004");
  for (const char* steps : {"t_*.nrrd", "t_2.nrrd;t_1.nrrd"}) {
    const std::string path = (folder / "real" / steps).string();
    EXPECT_EQ(storedPath(path, folder), std::string("real/") + steps);
    EXPECT_EQ(pathFromStored(steps, {folder / "linked", folder / "real"}), path);
  }
}

TEST(Session, ALightProbeIsFoundInAMovedFolderFromAnywhere) {
  const fs::path folder = test::temporaryFolder();
  fs::create_directories(folder / "old" / "light");
  Scene scene;
  scene.light.environment.file = (folder / "old" / "light" / "probe.hdr").string();
  saveSession(scene, folder / "old" / "s.isolux");
  EXPECT_EQ(test::contentOf(folder / "old" / "s.isolux").find(folder.string()), std::string::npos);
  fs::rename(folder / "old", folder / "new");
  const fs::path expected = folder / "new" / "light" / "probe.hdr";
  EXPECT_EQ(loadSession(folder / "new" / "s.isolux").light.environment.file, expected.string());
  const fs::path before = fs::current_path();
  fs::current_path(folder / "new" / "light");
  EXPECT_EQ(loadSession("../s.isolux").light.environment.file, expected.string());
  fs::current_path(before);
}

TEST(Session, ALinkFindsItsVolumeBesideItselfOrBesideTheSession) {
  const fs::path folder = test::temporaryFolder();
  fs::create_directories(folder / "data");
  fs::create_directories(folder / "desk");
  writeFile(folder / "data" / "ct.nii", "x");
  Scene scene;
  scene.source.path = (folder / "data" / "ct.nii").string();
  saveSession(scene, folder / "data" / "s.isolux");
  fs::create_symlink("../data/s.isolux", folder / "desk" / "link.isolux");
  EXPECT_EQ(loadSession(folder / "desk" / "link.isolux").source.path, (folder / "data" / "ct.nii").string());
  writeFile(folder / "desk" / "ct.nii", "x");
  EXPECT_EQ(loadSession(folder / "desk" / "link.isolux").source.path, (folder / "desk" / "ct.nii").string());
}

TEST(Session, UpgradesVersion1) {
  const Scene scene = parseSession(
      R"({"isolux_session": 1, "program": "0.0.9",
          "settings": {"isosurface.value": 300, "camera.eye": [1, 2, 3], "source.path": "ct.nii", "look.mode": "depth"}})",
      "old.isolux", {"/data"});
  Scene expected = litAsBefore();
  expected.surfaces.front().value = 300;
  expected.camera.eye = glm::dvec3(1, 2, 3);
  expected.source.path = "/data/ct.nii";
  expected.look.mode = scene::LookMode::depth;
  EXPECT_TRUE(scene == expected);
  EXPECT_TRUE(parseSession(R"({"isolux_session": 1})", "", {"/data"}) == litAsBefore());
}

TEST(Session, OfBeforeScalesKeepsItsDerivatives) {
  const auto read = [](const std::string& text) { return parseSession(text, "a.isolux", {"/data"}); };
  EXPECT_TRUE(read(R"({"isolux_session": 4, "scene": {}})") == derivedAsBefore());
  const Scene tone = read(R"({"isolux_session": 4, "scene": {"look": {"mode": "tone", "contours": 0.3}}})");
  EXPECT_EQ(tone.look.contours, 0.3);
  EXPECT_EQ(tone.derivatives.scale, 0.0);
}

TEST(Session, RefusesBadVersion1WithThePath) {
  EXPECT_THAT(sessionRefusal(R"({"isolux_session": 1, "settings": {"camera.fow": 3}})"),
              HasSubstr("camera.fow"));
  EXPECT_THAT(sessionRefusal(R"({"isolux_session": 1, "settings": {"fov": 3}})"), HasSubstr("settings.fov"));
  EXPECT_THAT(sessionRefusal(R"({"isolux_session": 1, "settings": {"a.b.c": 3}})"),
              HasSubstr("settings.a.b.c"));
  EXPECT_THAT(sessionRefusal(R"({"isolux_session": 1, "settings": []})"), HasSubstr("settings"));
  EXPECT_THAT(sessionRefusal(R"({"isolux_session": 1, "scene": {}})"), HasSubstr("scene: unknown key"));
}

TEST(Session, OfEveryVersionOpensAndIsKeptBySaving) {
  std::size_t found = 0;
  const fs::path folder = fs::path(ISOLUX_SOURCE_DIR) / "tests/app/same_picture/sessions";
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path().filename());
    const Scene scene = loadSession(entry.path());
    EXPECT_EQ(parseSession(sessionText(scene, "/"), "again.isolux", {"/"}), scene);
    EXPECT_NE(scene, Scene{});
    ++found;
  }
  EXPECT_GE(found, 30u);
}

TEST(Session, MissingKeysTakeDefaults) {
  EXPECT_TRUE(parseSession(R"({"isolux_session": 10})", "", {"/"}) == Scene{});
  EXPECT_TRUE(parseSession(R"({"isolux_session": 10, "scene": {}})", "", {"/"}) == Scene{});
  EXPECT_TRUE(parseSession(R"({"isolux_session": 9})", "", {"/"}) == labelledAsBefore());
  EXPECT_TRUE(parseSession(R"({"isolux_session": 7})", "", {"/"}) == shadedAsBefore());
  EXPECT_TRUE(parseSession(R"({"isolux_session": 6})", "", {"/"}) == firstSeenAsBefore());
  EXPECT_TRUE(parseSession(R"({"isolux_session": 5, "accuracy": {"pixels": 7}})", "", {"/"}) ==
              firstSeenAsBefore());
  EXPECT_TRUE(parseSession(R"({"isolux_session": 5, "scene": {}})", "", {"/"}) == firstSeenAsBefore());
  EXPECT_TRUE(parseSession(R"({"isolux_session": 2, "scene": {}})", "", {"/"}) == litAsBefore());
}

TEST(Session, UnknownKeysFailWithTheirPath) {
  EXPECT_THAT(sessionRefusal(R"({"isolux_session": 2, "scenes": {}})"), HasSubstr("scenes: unknown key"));
  EXPECT_THAT(sessionRefusal(R"({"isolux_session": 2, "scene": {"camera": {"fow": 1}}})"),
              AllOf(HasSubstr("scene.camera.fow"), HasSubstr("did you mean camera.fov?")));
  EXPECT_THAT(sessionRefusal(R"({"isolux_session": 2, "scene": {"kamera": {}}})"), HasSubstr("scene.kamera"));
  EXPECT_THAT(sessionRefusal(R"({"isolux_session": 2, "settings": {}})"), HasSubstr("settings"));
}

TEST(Session, ValuesAreCheckedWithTheirPath) {
  EXPECT_THAT(sessionRefusal(R"({"isolux_session": 2, "scene": {"camera": {"fov": 500}}})"),
              AllOf(HasSubstr("scene.camera.fov"), HasSubstr("500"), HasSubstr("1 to 160")));
  EXPECT_THAT(sessionRefusal(R"({"isolux_session": 2, "scene": {"camera": {"fov": "wide"}}})"),
              HasSubstr("scene.camera.fov"));
  EXPECT_THAT(sessionRefusal(R"({"isolux_session": 2, "scene": {"camera": {"fov": 1e999}}})"),
              HasSubstr("out of range"));
  EXPECT_THAT(sessionRefusal(R"({"isolux_session": 2, "scene": 7})"), HasSubstr("scene"));
}

TEST(Session, EqualKeysAreRefused) {
  EXPECT_THAT(
      sessionRefusal(R"({"isolux_session": 6, "scene": {"look": {"mode": "gi"}, "camera": {}, "look": {}}})"),
      HasSubstr("look: is there twice"));
  EXPECT_THAT(sessionRefusal(R"({"isolux_session": 6, "isolux_session": 6})"), HasSubstr("is there twice"));
}

TEST(Session, FutureVersionsSaySo) {
  EXPECT_THAT(sessionRefusal(R"({"isolux_session": 11, "scene": {"new": 1}})"),
              AllOf(HasSubstr("version 10"), HasSubstr("newer Isolux")));
  EXPECT_THAT(sessionRefusal(R"({"isolux_session": 18446744073709551615})"), HasSubstr("newer Isolux"));
}

TEST(Session, WhatIsNoSessionSaysSo) {
  EXPECT_THAT(sessionRefusal(""), HasSubstr("JSON"));
  EXPECT_THAT(sessionRefusal("{\"isolux_session\": 2,}"), HasSubstr("line 1, column 22"));
  EXPECT_THAT(sessionRefusal("[]"), HasSubstr("not a session"));
  EXPECT_THAT(sessionRefusal("{}"), HasSubstr("isolux_session"));
  for (const char* version : {"0", "-1", "1.5", "\"2\"", "null", "true"})
    EXPECT_THAT(sessionRefusal(std::string("{\"isolux_session\": ") + version + "}"),
                HasSubstr("version must be"));
  EXPECT_THAT(sessionRefusal("{\"isolux_session\": 2, \"scene\": {\"source\": {\"path\": \"\xff\"}}}"),
              HasSubstr("column"));
  EXPECT_THAT(sessionRefusal("{\n  \"isolux_session\": 2,\n  \"scene\" {}\n}"),
              HasSubstr("line 3, column 11"));
  const std::string deep(300000, '[');
  EXPECT_THAT(sessionRefusal(deep + std::string(300000, ']')), HasSubstr("not a session"));
}

TEST(Session, TravelsInAPicture) {
  const fs::path folder = test::temporaryFolder();
  const render::ColorImage image{{2, 1}, {255, 0, 0, 255, 1, 2, 3, 255}};
  Scene scene = someScene();
  scene.source.path = (folder / "ünï.nii").string();
  writePng(image, folder / "a.png", sessionText(scene, folder));
  EXPECT_TRUE(isSession(folder / "a.png"));
  EXPECT_TRUE(loadSession(folder / "a.png") == scene);

  writePng(image, folder / "plain.png", "");
  EXPECT_FALSE(isSession(folder / "plain.png"));
  EXPECT_THROW(loadSession(folder / "plain.png"), base::Error);
  writePng(image, folder / "broken.png", "{\"isolux_session\": 99}");
  EXPECT_THROW(loadSession(folder / "broken.png"), base::Error);
}

// The state folder of the running test, in place of the user's.
class OwnStateFolder {
 public:
  OwnStateFolder() {
    if (const char* old = std::getenv("XDG_STATE_HOME")) old_ = old;
    ::setenv("XDG_STATE_HOME", (test::temporaryFolder() / "state").c_str(), 1);
  }
  ~OwnStateFolder() {
    old_.empty() ? ::unsetenv("XDG_STATE_HOME") : ::setenv("XDG_STATE_HOME", old_.c_str(), 1);
  }

 private:
  std::string old_;
};

// Names in an old encoding, which no JSON text holds as they are.
TEST(Session, AnyBytesOfANameAreFoundAgain) {
  const fs::path folder = test::temporaryFolder(), far = test::temporaryFolder();
  const OwnStateFolder state;
  const render::ColorImage image{{1, 1}, {255, 0, 0, 255}};
  for (const char* name : {"b\xff\xfe 100%.mha", "bytes:plain.mha", "K\xf6pfe.mha"}) {
    std::ofstream(folder / name) << "x";
    Scene scene;
    scene.source.path = (folder / name).string();
    saveSession(scene, folder / "s.isolux");
    EXPECT_EQ(loadSession(folder / "s.isolux").source.path, scene.source.path);
    saveSession(scene, far / "s.isolux");
    EXPECT_EQ(loadSession(far / "s.isolux").source.path, scene.source.path);
    writePng(image, far / "a.png", pictureSessionText(scene, far));
    EXPECT_EQ(loadSession(far / "a.png").source.path, scene.source.path) << "by its place";
  }
}

TEST(Session, OfASharedPictureNamesNoFolderAndFindsItsFilesAgain) {
  const fs::path folder = test::temporaryFolder();
  for (const char* name : {"patients/doe", "probes", "pictures", "elsewhere"})
    fs::create_directories(folder / name);
  const OwnStateFolder state;
  Scene scene;
  scene.source.path = (folder / "patients" / "doe" / "ct.nii").string();
  scene.source.csgPath = (folder / "pictures" / "cut.stl").string();  // beside the picture
  scene.light.environment.file = (folder / "probes" / "sky.hdr").string();
  for (const std::string& file : {scene.source.path, scene.source.csgPath, scene.light.environment.file})
    writeFile(file, "x");

  const std::string text = pictureSessionText(scene, folder / "pictures");
  EXPECT_EQ(text.find(folder.string()), std::string::npos) << text;
  EXPECT_EQ(text.find("doe"), std::string::npos) << text;
  EXPECT_EQ(text.find(".."), std::string::npos) << text;
  EXPECT_EQ(text, pictureSessionText(scene, folder / "pictures")) << "a path's token is always the same";

  EXPECT_TRUE(parseSession(text, "a.png", {folder / "pictures"}) == scene);
  const Scene moved = parseSession(text, "a.png", {folder / "elsewhere"});
  EXPECT_EQ(moved.source.path, scene.source.path) << "the picture moved, the volume did not";
  EXPECT_EQ(moved.source.csgPath, (folder / "elsewhere" / "cut.stl").string());

  // On another machine the token says nothing: what lies beside the picture counts.
  fs::remove_all(stateFolder());
  const Scene given = parseSession(text, "a.png", {folder / "elsewhere"});
  EXPECT_EQ(given.source.path, (folder / "elsewhere" / "ct.nii").string());
  EXPECT_EQ(given.light.environment.file, (folder / "elsewhere" / "sky.hdr").string());
}

TEST(Session, APictureDoesNotNameThePatientAndStillOpens) {
  const fs::path folder = test::temporaryFolder();
  fs::create_directories(folder / "DOE_JANE_ID4711");
  const OwnStateFolder state;
  const volume::Patient patient{"DOE^JANE", "ID4711", "19600102"};
  Scene scene;
  scene.source.path = (folder / "DOE_JANE_ID4711").string();
  scene.marks.push_back({.name = "Doe, left", .points = {{1, 2, 3}}});
  // In a folder of its own, and beside the volume.
  for (const fs::path& pictures : {folder / "DOE_JANE_ID4711" / "pictures", folder}) {
    const std::string text = pictureSessionText(scene, pictures, patient);
    EXPECT_EQ(text.find("DOE"), std::string::npos) << text;
    EXPECT_EQ(text.find("4711"), std::string::npos) << text;
    const Scene opened = parseSession(text, "a.png", {pictures});
    EXPECT_EQ(opened.source.path, scene.source.path);
    EXPECT_EQ(opened.marks.front().name, "anonymous, left");
  }
  EXPECT_NE(pictureSessionText(scene, folder).find("DOE_JANE"), std::string::npos)
      << "nobody is hidden unasked";
}

TEST(Session, AnotherVolumeOfTheSameNameBesideThePictureIsNotTaken) {
  const fs::path folder = test::temporaryFolder();
  const OwnStateFolder state;
  for (const char* name : {"a", "b", "pictures"}) {
    fs::create_directories(folder / name);
    writeFile(folder / name / "ct.nii", name);
  }
  for (const char* name : {"a", "b"}) {
    Scene scene;
    scene.source.path = (folder / name / "ct.nii").string();
    const std::string text = pictureSessionText(scene, folder / "pictures");
    EXPECT_EQ(parseSession(text, "a.png", {folder / "pictures"}).source.path, scene.source.path);
  }
}

TEST(Session, PlacesThatAreNoneAreRefused) {
  EXPECT_THAT(sessionRefusal(R"({"isolux_session": 3, "places": 7})"), HasSubstr("places"));
  EXPECT_THAT(sessionRefusal(R"({"isolux_session": 3, "places": {"source.path": 7}})"),
              HasSubstr("source.path"));
  EXPECT_THAT(sessionRefusal(R"({"isolux_session": 3, "places": {"camera.fov": "a"}})"),
              HasSubstr("camera.fov"));
  EXPECT_THAT(sessionRefusal(R"({"isolux_session": 2, "places": {}})"), HasSubstr("places"));
}

TEST(Session, BrokenPicturesCarryNone) {
  const fs::path folder = test::temporaryFolder();
  const render::ColorImage image{{1, 1}, {1, 2, 3, 255}};
  writePng(image, folder / "whole.png", sessionText(someScene(), folder));
  const std::string whole = test::contentOf(folder / "whole.png");
  const std::size_t key = whole.find("isolux_session");
  ASSERT_NE(key, std::string::npos);
  for (const std::size_t length : {std::size_t{8}, std::size_t{11}, key - 5, key + 3, key + 40}) {
    writeFile(folder / "cut.png", whole.substr(0, length));
    EXPECT_FALSE(isSession(folder / "cut.png")) << length;
  }
  std::string lies = whole;
  lies.replace(key - 8, 4, "\x7f\xff\xff\xff");  // the chunk claims 2 GiB
  writeFile(folder / "lies.png", lies);
  EXPECT_FALSE(isSession(folder / "lies.png"));
  EXPECT_THROW(readSessionText(folder / "missing.png"), base::Error);
}

TEST(Session, IsToldByContent) {
  const fs::path folder = test::temporaryFolder();
  writeFile(folder / "a.json", "  {\"scene\": {}, \"isolux_session\": 2}");
  writeFile(folder / "b.json", "{\"something\": \"else\"}");
  writeFile(folder / "c.isolux", "{ broken");
  writeFile(folder / "d.isolux", "");
  writeFile(folder / "e.png", "\x89PNG\r\n\x1a\nand then nonsense");
  EXPECT_TRUE(isSession(folder / "a.json"));
  EXPECT_FALSE(isSession(folder / "b.json"));
  EXPECT_TRUE(isSession(folder / "c.isolux")) << "its own message is the better one";
  EXPECT_FALSE(isSession(folder / "d.isolux"));
  EXPECT_FALSE(isSession(folder / "e.png"));
  EXPECT_FALSE(isSession(folder / "missing"));
  EXPECT_FALSE(isSession(folder));
  EXPECT_FALSE(isSession("phantom:head"));
}

TEST(Session, FailuresNameTheFile) {
  const fs::path folder = test::temporaryFolder();
  try {
    loadSession(folder / "missing.isolux");
    FAIL();
  } catch (const base::Error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("missing.isolux"), HasSubstr("does not exist")));
  }
  EXPECT_THROW(saveSession(Scene{}, folder / "no" / "folder.isolux"), base::Error);
  EXPECT_THROW(saveSession(Scene{}, folder), base::Error);
}

}  // namespace
}  // namespace isolux::app
