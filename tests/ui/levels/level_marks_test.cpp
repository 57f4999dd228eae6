// What an overview hides: hatched in the picture and said in the status line, where the volume has an index.
#include <string>

#include <QAction>
#include <QCoreApplication>
#include <QLabel>

#include "tests/support/ui/needles.h"
#include "tests/support/ui/window_fixture.h"
#include "ui/accuracy/accuracy_panel.h"
#include "ui/accuracy/error_overlay_box.h"
#include "ui/levels/level_marks.h"
#include "ui/viewport/viewport.h"
#include "volume/large/index_file.h"
#include "volume/read/volume_file.h"

namespace isolux::test {
namespace {

using Over = ui::Viewport::Over;

class LevelMarksTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    window_->fullResolutionAction()->setChecked(false);  // its pictures take the place of marked ones
    file_ = writeNeedles(newFile("needles.nrrd"));
  }
  void makeIndex() {
    scene::Source source;
    source.path = file_.toStdString();
    base::Progress progress;
    std::optional<volume::VolumeIndex> index;
    volume::IndexFile(source.path, volume::readOptions(source))
        .make(*volume::openSource(source, progress).parts, {}, index, progress);
  }
  void showLevel(int level) {
    if (window_->document()->volume() == nullptr) {
      ASSERT_TRUE(load(*window_, file_));
    }
    ui::Edit edit{window_->document()->scene(), "level", {}, false};
    edit.scene.source.level = level;
    edit.scene.surfaces.front().value = 100.0;
    edit.scene.camera.eye = glm::dvec3(150.0, 40.0, 60.0);  // needles before the block
    edit.scene.camera.target = glm::dvec3(31.5);
    window_->document()->edit(edit);
    ASSERT_TRUE(waitUntil(
        [&] { return !window_->document()->loading() && window_->document()->shownLevel() == level; }));
    fullPicture(*window_);
  }
  bool awaitMarks() {
    return waitUntil([&] { return window_->viewport()->showsOver(Over::structure); });
  }
  ui::LevelMarks* marks() { return window_->panel<ui::LevelMarks>(); }
  QImage onScreen() {
    QCoreApplication::processEvents();
    return window_->viewport()->grab().toImage();
  }

  QString file_;
};

TEST_F(LevelMarksTest, WhatTheOverviewHidesIsHatchedAndSaid) {
  makeIndex();
  showLevel(2);
  ASSERT_TRUE(awaitMarks()) << marks()->meaning().toStdString();
  const QImage marked = onScreen();
  const QString said = window_->coarseLabel()->text();
  EXPECT_TRUE(said.startsWith("Overview: level 2 · may hide structure in ")) << said.toStdString();
  EXPECT_TRUE(window_->coarseLabel()->toolTip().contains("thinner than 8"));

  QAction* const action = window_->markLevelAction();
  EXPECT_TRUE(action->isEnabled() && action->isChecked());
  action->trigger();
  EXPECT_FALSE(window_->viewport()->showsOver(Over::structure));
  EXPECT_GT(differingPixels(marked, onScreen(), 20), 0.02);
  EXPECT_EQ(window_->coarseLabel()->text(), said) << "it hides as much without marks";
  action->trigger();
  EXPECT_TRUE(window_->viewport()->showsOver(Over::structure));
  EXPECT_LT(differingPixels(marked, onScreen(), 20), 0.001);

  showLevel(0);
  EXPECT_FALSE(window_->viewport()->showsOver(Over::structure));
  EXPECT_EQ(window_->coarseLabel()->text(), "");
  EXPECT_FALSE(action->isEnabled());
}

TEST_F(LevelMarksTest, EachPictureHasItsOwn) {
  makeIndex();
  showLevel(2);
  ASSERT_TRUE(awaitMarks());
  const QString before = window_->coarseLabel()->text();
  ui::Edit edit{window_->document()->scene(), "view", {}, false};
  edit.scene.camera.eye = glm::dvec3(320.0, 40.0, 60.0);
  window_->document()->edit(edit);
  EXPECT_TRUE(waitUntil([&] { return !window_->viewport()->showsOver(Over::structure); }));
  fullPicture(*window_);
  ASSERT_TRUE(awaitMarks());
  EXPECT_NE(window_->coarseLabel()->text(), before) << "from farther away it is a smaller share";

  edit.scene.surfaces.front().value = 250.0;  // of nothing
  window_->document()->edit(edit);
  fullPicture(*window_);
  EXPECT_TRUE(waitUntil([&] { return window_->coarseLabel()->text().contains("hides nothing"); }));
  EXPECT_FALSE(window_->viewport()->showsOver(Over::structure));
}

TEST_F(LevelMarksTest, ErrorsThatAreAskedForGoBefore) {
  makeIndex();
  showLevel(2);
  ASSERT_TRUE(awaitMarks());
  window_->showPanel("Accuracy");
  fullPicture(*window_);
  auto* const overlay = window_->panel<ui::AccuracyPanel>()->overlay();
  overlay->choose(app::ErrorImage::depth);
  ASSERT_TRUE(waitUntil([&] { return window_->viewport()->showsOver(Over::errors); }, 120000));
  overlay->choose(std::nullopt);
  EXPECT_FALSE(window_->viewport()->showsOver(Over::errors));
  EXPECT_TRUE(awaitMarks()) << "they are there again";
}

TEST_F(LevelMarksTest, WithoutAnIndexItSaysWhatWouldTell) {
  showLevel(1);
  EXPECT_TRUE(waitUntil([&] { return window_->coarseLabel()->toolTip().contains("isolux index"); }));
  EXPECT_EQ(window_->coarseLabel()->text(), "Overview: level 1");
  EXPECT_FALSE(window_->viewport()->showsOver(Over::structure));
  makeIndex();  // meanwhile, in a terminal: the next picture is marked
  ui::Edit edit{window_->document()->scene(), "view", {}, false};
  edit.scene.camera.fov = 35.0;
  window_->document()->edit(edit);
  fullPicture(*window_);
  EXPECT_TRUE(awaitMarks());
}

}  // namespace
}  // namespace isolux::test
