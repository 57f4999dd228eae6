#include "app/documents/history.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/settings/scene_diff.h"

namespace isolux::app {
namespace {

using scene::Scene;

Scene withFov(Scene scene, double fov) {
  scene.camera.fov = fov;
  return scene;
}

Scene withIsovalue(Scene scene, double value) {
  scene.surfaces.front().value = value;
  return scene;
}

TEST(History, UndoAndRedoWalkTheSteps) {
  History history;
  const Scene first = history.scene(), second = withFov(first, 40), third = withIsovalue(second, 300);
  EXPECT_FALSE(history.canUndo());
  EXPECT_EQ(history.undoName(), "");

  EXPECT_EQ(history.edit(second, "Set angle").changes.size(), 1u);
  history.edit(third, "Set isovalue");
  EXPECT_EQ(history.undoName(), "Set isovalue");

  const scene::SceneDiff undone = history.undo();
  EXPECT_EQ(undone.name, "Undo Set isovalue");
  EXPECT_TRUE(scene::applied(third, undone) == second);
  EXPECT_TRUE(history.scene() == second);
  EXPECT_EQ(history.redoName(), "Set isovalue");
  history.undo();
  EXPECT_TRUE(history.scene() == first);
  EXPECT_FALSE(history.canUndo());

  const scene::SceneDiff redone = history.redo();
  EXPECT_TRUE(scene::applied(first, redone) == second);
  history.redo();
  EXPECT_TRUE(history.scene() == third);
  EXPECT_FALSE(history.canRedo());
}

TEST(History, NothingToUndoOrRedoIsAnEmptyDiff) {
  History history;
  EXPECT_TRUE(history.undo().changes.empty());
  EXPECT_TRUE(history.redo().changes.empty());
  EXPECT_TRUE(history.edit(history.scene(), "Nothing").changes.empty());
  EXPECT_FALSE(history.canUndo());
}

TEST(History, AnEditForgetsWhatWasUndone) {
  History history;
  history.edit(withFov(history.scene(), 40), "A");
  history.undo();
  history.edit(withFov(history.scene(), 50), "B");
  EXPECT_FALSE(history.canRedo());
  EXPECT_EQ(history.undoName(), "B");
}

TEST(History, AGestureIsOneStep) {
  History history;
  const Scene before = history.scene();
  for (int i = 1; i <= 50; ++i) {
    const scene::SceneDiff diff = history.edit(withIsovalue(history.scene(), i), "Drag", "isovalue");
    EXPECT_EQ(diff.changes.at(0).value, double(i)) << "each move is reported on its own, for recordings";
  }
  EXPECT_EQ(history.scene().surfaces.front().value, 50.0);
  history.undo();
  EXPECT_TRUE(history.scene() == before);
  EXPECT_FALSE(history.canUndo());
  history.redo();
  EXPECT_EQ(history.scene().surfaces.front().value, 50.0);
}

TEST(History, SealOtherKeyAndNoKeyEndAGesture) {
  History history;
  history.edit(withFov(history.scene(), 31), "Zoom", "zoom");
  history.seal();
  history.edit(withFov(history.scene(), 32), "Zoom", "zoom");
  history.edit(withIsovalue(history.scene(), 5), "Drag", "isovalue");
  history.edit(withFov(history.scene(), 33), "Zoom", "zoom");
  history.edit(withFov(history.scene(), 34), "Zoom");
  history.edit(withFov(history.scene(), 35), "Zoom");
  int steps = 0;
  for (; history.canUndo(); ++steps) history.undo();
  EXPECT_EQ(steps, 6);
}

TEST(History, UndoEndsAGesture) {
  History history;
  history.edit(withFov(history.scene(), 31), "A", "drag");
  history.edit(withIsovalue(history.scene(), 1), "B", "other");
  history.undo();
  history.edit(withFov(history.scene(), 33), "C", "drag");
  history.undo();
  EXPECT_EQ(history.scene().camera.fov, 31.0);
}

TEST(History, AGestureBackToItsStartIsNoStep) {
  History history;
  history.edit(withIsovalue(history.scene(), 7), "Before", "isovalue");
  history.seal();
  const Scene before = history.scene();
  history.edit(withFov(before, 50), "Zoom", "zoom");
  history.edit(before, "Zoom", "zoom");
  EXPECT_EQ(history.undoName(), "Before");
  history.edit(withFov(before, 60), "Zoom", "zoom");
  EXPECT_EQ(history.undoName(), "Zoom");
  history.undo();
  EXPECT_TRUE(history.scene() == before);
}

TEST(History, ARefusedSceneChangesNothing) {
  History history;
  history.edit(withFov(history.scene(), 40), "A");
  const Scene before = history.scene();
  EXPECT_THROW(history.edit(withFov(before, 1000), "Bad"), base::Error);
  EXPECT_THROW(history.edit(withFov(before, std::nan("")), "Bad"), base::Error);
  EXPECT_TRUE(history.scene() == before);
  EXPECT_EQ(history.undoName(), "A");
}

TEST(History, ResetStartsAnew) {
  History history;
  history.edit(withFov(history.scene(), 40), "A");
  history.reset(withFov(Scene{}, 70));
  EXPECT_EQ(history.scene().camera.fov, 70.0);
  EXPECT_FALSE(history.canUndo() || history.canRedo());
}

}  // namespace
}  // namespace isolux::app
