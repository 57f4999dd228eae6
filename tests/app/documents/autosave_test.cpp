#include "app/documents/autosave.h"

#include <csignal>
#include <cstdlib>
#include <fstream>

#include <sys/wait.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/files/files.h"
#include "app/files/state_folder.h"
#include "scene/settings/settings.h"
#include "tests/app/commands/run_isolux.h"
#include "tests/support/test_data.h"

namespace isolux::app {
namespace {

namespace fs = std::filesystem;
using scene::Scene;
using std::chrono::seconds;
using testing::HasSubstr;

// Ten edits of different kinds, the last two undone.
OpenDocument someDocument() {
  Scene scene;
  scene.source.path = "/data/ct head.nii.gz";
  OpenDocument document{"ct head.nii.gz", History(scene), scene, "/data/ct.isolux", "/data/tour.jsonl"};
  const char* const edits[] = {"isosurface.value=300.125",
                               "look.mode=gi",
                               "camera.eye=0.1,-400,1e-7",
                               "light.environment.file=/probes/ünï.hdr",
                               "look.ridges=0.333333333333333",
                               "camera.projection=orthographic",
                               "light.environment.constant=1,0,0",
                               "isosurface.value=auto",
                               "camera.fov=40",
                               "look.mode=normal"};
  for (const char* edit : edits) {
    Scene next = document.history.scene();
    scene::applyAssignment(next, edit);
    document.history.edit(next, edit);
  }
  document.history.undo();
  document.history.undo();
  return document;
}

// All scenes that undo and redo lead to, from first to last.
std::vector<Scene> scenesOf(History history) {
  while (history.canUndo()) history.undo();
  std::vector<Scene> scenes{history.scene()};
  while (history.canRedo()) {
    history.redo();
    scenes.push_back(history.scene());
  }
  return scenes;
}

void expectSame(const OpenDocument& a, const OpenDocument& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.sessionFile, b.sessionFile);
  EXPECT_EQ(a.recordingFile, b.recordingFile);
  EXPECT_TRUE(a.saved == b.saved);
  EXPECT_TRUE(a.history.scene() == b.history.scene());
  EXPECT_EQ(a.history.position(), b.history.position());
  EXPECT_EQ(a.history.undoName(), b.history.undoName());
  EXPECT_EQ(a.history.redoName(), b.history.redoName());
  EXPECT_TRUE(scenesOf(a.history) == scenesOf(b.history));
}

// Writes an autosave in a process of its own that is then killed, as by `kill -9`.
void writeAndBeKilled(const fs::path& folder, const OpenDocument& document) {
  const pid_t child = ::fork();
  if (child == 0) {
    AutosaveFile file(folder);
    file.write(document);
    file.finish();
    ::raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
}

TEST(Autosave, HoldsTheSceneTheWholeUndoListAndWhatWasSaved) {
  const OpenDocument document = someDocument();
  const auto time = std::chrono::system_clock::time_point(seconds(1'700'000'000));
  const Autosave read = parseAutosave(autosaveText({document, time}), "a");
  EXPECT_TRUE(read.time == time);
  expectSame(read.document, document);
}

TEST(Autosave, IsOfferedAfterAKillOnceAndToOneOnly) {
  const fs::path folder = test::temporaryFolder() / "new" / "autosave";
  EXPECT_TRUE(takeLostAutosaves(folder).found.empty());
  const OpenDocument document = someDocument();
  using std::chrono::system_clock;
  const auto before = std::chrono::floor<seconds>(system_clock::now());
  writeAndBeKilled(folder, document);
  {
    LostAutosaves lost = takeLostAutosaves(folder);
    ASSERT_EQ(lost.found.size(), 1u);
    EXPECT_TRUE(lost.damaged.empty());
    expectSame(lost.found[0].content.document, document);
    EXPECT_TRUE(before <= lost.found[0].content.time && lost.found[0].content.time <= system_clock::now());
    EXPECT_TRUE(takeLostAutosaves(folder).found.empty()) << "offered to two windows at once";
  }
  LostAutosaves again = takeLostAutosaves(folder);  // not answered: offered at the next start too
  ASSERT_EQ(again.found.size(), 1u);
  again.found[0].discard();
  EXPECT_TRUE(test::filesIn(folder).empty()) << "something was left behind";
}

TEST(Autosave, OfALivingWindowIsNotOffered) {
  const fs::path folder = test::temporaryFolder();
  AutosaveFile mine(folder), other(folder);
  EXPECT_NE(mine.path(), other.path());
  mine.write(someDocument());
  other.write(someDocument());
  mine.finish();
  other.finish();
  EXPECT_TRUE(takeLostAutosaves(folder).found.empty());
  EXPECT_EQ(test::filesIn(folder).size(), 4u) << "each its file and its lock";
  EXPECT_FALSE(mine.problem() || other.problem());
}

TEST(Autosave, IsGoneAfterACleanExit) {
  const fs::path folder = test::temporaryFolder();
  {
    AutosaveFile file(folder);
    file.write(someDocument());
    file.finish();
    EXPECT_TRUE(fs::exists(file.path()));
    file.remove();
    file.finish();
    EXPECT_FALSE(fs::exists(file.path()));
    file.write(someDocument());  // the window goes on after all
    file.remove();
  }
  EXPECT_TRUE(test::filesIn(folder).empty());
}

TEST(Autosave, TheNewestWishIsOnDiskAtTheEnd) {
  const fs::path folder = test::temporaryFolder();
  fs::path path;
  OpenDocument document = someDocument();
  {
    AutosaveFile file(folder);
    path = file.path();
    for (int i = 0; i < 200; ++i) {
      Scene next = document.history.scene();
      next.camera.fov = 20.0 + 0.1 * i;
      document.history.edit(next, "Zoom");
      file.write(document);
    }
  }
  expectSame(parseAutosave(readTextFile(path, 1u << 30), "a").document, document);
}

TEST(Autosave, DamagedOnesAreKeptAsideAndNeverOffered) {
  const std::string whole = autosaveText({someDocument(), {}});
  const fs::path folder = test::temporaryFolder();
  int count = 0;
  const auto write = [&](const std::string& text) {
    std::ofstream(folder / (std::to_string(count++) + ".autosave"), std::ios::binary) << text;
  };
  for (std::size_t length = 0; length + 2 < whole.size(); length += 97) write(whole.substr(0, length));
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string text = whole;
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  };
  write(replaced("\"isolux_autosave\":1", "\"isolux_autosave\":2"));
  write(replaced("\"position\":8", "\"position\":11"));
  write(replaced("\"position\":8", "\"position\":-1"));
  write(replaced("\"camera.fov\":40", "\"camera.fov\":4000"));
  write(replaced("\"camera.fov\":40", "\"camera.fow\":40"));
  write(replaced("\"steps\":[", "\"steps\":[7,"));
  write(replaced("\"name\":\"ct head.nii.gz\"", "\"name\":7"));
  write(replaced("\"scene\":{", "\"scene\":{\"more\":1,"));
  const LostAutosaves lost = takeLostAutosaves(folder);
  EXPECT_TRUE(lost.found.empty());
  ASSERT_EQ(lost.damaged.size(), static_cast<std::size_t>(count));
  for (const fs::path& file : lost.damaged) EXPECT_TRUE(fs::exists(file)) << file;
  EXPECT_EQ(test::filesIn(folder).size(), static_cast<std::size_t>(count)) << "kept aside, without locks";
  EXPECT_TRUE(takeLostAutosaves(folder).damaged.empty()) << "told once";
}

TEST(Autosave, AFolderThatCannotBeMadeIsTold) {
  const fs::path folder = test::temporaryFolder();
  std::ofstream(folder / "file") << "no folder";
  AutosaveFile file(folder / "file" / "autosave");
  file.write(someDocument());
  file.finish();
  const auto problem = file.problem();
  ASSERT_TRUE(problem);
  EXPECT_THAT(problem->what(), HasSubstr("autosave"));
  fs::remove(folder / "file");
  file.write(someDocument());
  file.finish();
  EXPECT_FALSE(file.problem()) << "tried again, with success";
}

TEST(Autosave, AnUntouchedPhantomIsNotWorthKeeping) {
  OpenDocument document;
  document.history.reset(document.saved);
  document.saved.source.path = "phantom:head";
  document.history.reset(document.saved);
  EXPECT_FALSE(worthKeeping(document));
  Scene turned = document.saved;
  turned.camera.fov = 40;
  document.history.edit(turned, "Zoom");
  EXPECT_TRUE(worthKeeping(document));
  document.history.undo();
  EXPECT_TRUE(worthKeeping(document)) << "what could be redone";
  document.saved.source.path = "/data/ct.nii";
  document.history.reset(document.saved);
  EXPECT_TRUE(worthKeeping(document)) << "an opened scan is offered again";
}

TEST(Autosave, AgesAreTold) {
  EXPECT_EQ(agoText(seconds(-5)), "0 s ago");
  EXPECT_EQ(agoText(seconds(20)), "20 s ago");
  EXPECT_EQ(agoText(seconds(119)), "1 min ago");
  EXPECT_EQ(agoText(seconds(3 * 3600 + 5)), "3 h ago");
  EXPECT_EQ(agoText(seconds(72 * 3600)), "3 days ago");
}

TEST(StateFolder, FollowsTheEnvironment) {
  const char* const home = std::getenv("HOME");
  const std::string oldHome = home ? home : "";
  const char* const state = std::getenv("XDG_STATE_HOME");
  const std::string oldState = state ? state : "";
  ::setenv("XDG_STATE_HOME", "/state", 1);
  EXPECT_EQ(stateFolder(), "/state/isolux");
  ::setenv("XDG_STATE_HOME", "relative", 1);
  ::setenv("HOME", "/home/someone", 1);
  EXPECT_EQ(stateFolder(), "/home/someone/.local/state/isolux");
  ::unsetenv("HOME");
  EXPECT_TRUE(stateFolder().empty() || stateFolder().is_absolute());
  home ? ::setenv("HOME", oldHome.c_str(), 1) : ::unsetenv("HOME");
  state ? ::setenv("XDG_STATE_HOME", oldState.c_str(), 1) : ::unsetenv("XDG_STATE_HOME");
}

TEST(StateFolder, IsForTheUsersEyesOnly) {
  const fs::path folder = test::temporaryFolder() / "a" / "b";
  makePrivateFolder(folder);
  EXPECT_EQ(fs::status(folder).permissions() & fs::perms::all, fs::perms::owner_all);
  makePrivateFolder(folder);  // there already
}

}  // namespace
}  // namespace isolux::app
