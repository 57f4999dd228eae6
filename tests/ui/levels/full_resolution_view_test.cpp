// Level 0 after a coarser level: drawn from the file, with an index made in the background, shown at rest,
// saved as it is seen; and nothing of it where it is not wanted.
#include <filesystem>
#include <fstream>
#include <string>

#include <QAction>
#include <QLabel>

#include "app/files/image_io.h"
#include "tests/support/ui/needles.h"
#include "tests/support/ui/window_fixture.h"
#include "ui/levels/full_resolution_view.h"
#include "ui/levels/level_marks.h"
#include "ui/viewport/viewport.h"
#include "ui/window/message_bar.h"

namespace isolux::test {
namespace {

using Over = ui::Viewport::Over;

class FullResolutionViewTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    window_->fullResolutionAction()->setChecked(true);
    file_ = writeNeedles(newFile("needles.nrrd"));
  }
  void edit(const std::function<void(scene::Scene&)>& change) {
    ui::Edit edit{window_->document()->scene(), "test", {}, false};
    change(edit.scene);
    window_->document()->edit(edit);
  }
  void showLevel(int level) {
    if (window_->document()->volume() == nullptr) {
      ASSERT_TRUE(load(*window_, file_));
    }
    edit([&](scene::Scene& scene) { scene.source.level = level; });  // loaded before other edits count
    ASSERT_TRUE(waitUntil(
        [&] { return !window_->document()->loading() && window_->document()->shownLevel() == level; }));
    edit([](scene::Scene& scene) {
      scene.surfaces.front().value = 100.0;
      scene.picture.restHits = scene::StillField::same;
      scene.derivatives.scale = scene.derivatives.normalScale = scene.derivatives.noise = 0.0;
      scene.camera.eye = glm::dvec3(150.0, 40.0, 60.0);
      scene.camera.target = glm::dvec3(31.5);
      scene.camera.up = glm::dvec3(0.0, 0.0, 1.0);
    });
    fullPicture(*window_);
  }
  bool isOn() { return window_->viewport()->showsOver(Over::levelZero); }
  bool awaitFullResolution() {
    return waitUntil([&] { return isOn(); });
  }
  ui::FullResolutionView* zero() { return window_->panel<ui::FullResolutionView>(); }
  std::string said() { return window_->coarseLabel()->text().toStdString(); }
  std::string tip() { return window_->coarseLabel()->toolTip().toStdString(); }
  bool hasIndex() const { return std::filesystem::exists(file_.toStdString() + ".index"); }

  QString file_;
};

TEST_F(FullResolutionViewTest, AFinishedPictureOfALevelIsFollowedByOneOfTheVolumeItself) {
  ASSERT_FALSE(hasIndex());
  showLevel(2);
  ASSERT_TRUE(awaitFullResolution()) << tip();
  EXPECT_EQ(said(), "Full resolution (level 2 in motion)");
  EXPECT_TRUE(hasIndex()) << "made in the background";
  EXPECT_FALSE(zero()->working());
  const QImage fromFile = zero()->image(), level = window_->viewport()->shown();
  showLevel(0);
  EXPECT_FALSE(isOn());
  EXPECT_EQ(said(), "");
  const QImage inMemory = window_->viewport()->shown();
  EXPECT_LT(differingPixels(fromFile, inMemory, 8), 0.001) << "needles and all";
  EXPECT_GT(differingPixels(level, inMemory, 8), 0.02);
}

TEST_F(FullResolutionViewTest, EachRestHasItsOwnPictureAndMotionTakesItAway) {
  showLevel(2);
  ASSERT_TRUE(awaitFullResolution());
  const QImage first = zero()->image();
  edit([](scene::Scene& scene) { scene.camera.eye = glm::dvec3(150.0, 90.0, 90.0); });
  EXPECT_FALSE(zero()->shows());
  EXPECT_TRUE(waitUntil([&] { return !isOn(); }));
  EXPECT_EQ(said().find("Overview: level 2"), 0u) << said();
  ASSERT_TRUE(awaitFullResolution());
  EXPECT_GT(differingPixels(zero()->image(), first, 8), 0.02);
  // Another level of the same volume: it is open already.
  showLevel(1);
  ASSERT_TRUE(awaitFullResolution());
  EXPECT_EQ(said(), "Full resolution (level 1 in motion)");
}

// A view that is left before its picture of level 0 is there never shows it.
TEST_F(FullResolutionViewTest, APictureThatWasDroppedIsNotShownOfAnotherView) {
  showLevel(2);
  ASSERT_TRUE(awaitFullResolution());
  const QImage seen = zero()->image();
  const glm::dvec3 eye(150.0, 40.0, 60.0);
  for (int i = 1; i < 6; ++i) {
    edit([&](scene::Scene& scene) { scene.camera.eye = eye + glm::dvec3(0.0, 10.0 * i, 0.0); });
    waitUntil([&] { return zero()->working(); }, 3000);
    waitUntil([] { return false; }, 20 * i);
  }
  edit([&](scene::Scene& scene) { scene.camera.eye = eye; });
  ASSERT_TRUE(waitUntil([&] { return window_->viewport()->complete() && isOn(); }));
  EXPECT_EQ(differingPixels(zero()->image(), seen, 0), 0.0);
}

TEST_F(FullResolutionViewTest, NothingOfItRunsWhereItIsNotWanted) {
  window_->fullResolutionAction()->setChecked(false);
  EXPECT_FALSE(zero()->wanted());
  showLevel(2);
  waitUntil([&] { return zero()->working(); }, 1500);
  EXPECT_FALSE(zero()->working());
  EXPECT_FALSE(hasIndex());
  EXPECT_EQ(said(), "Overview: level 2");
  window_->fullResolutionAction()->trigger();  // of the picture that is there
  ASSERT_TRUE(awaitFullResolution());
  window_->fullResolutionAction()->trigger();
  EXPECT_FALSE(isOn());
  EXPECT_EQ(said().find("Overview: level 2"), 0u) << said();
  showLevel(0);
  EXPECT_FALSE(window_->fullResolutionAction()->isEnabled());
}

TEST_F(FullResolutionViewTest, WhatCannotBeDrawnFromAFileIsSaid) {
  showLevel(2);
  ASSERT_TRUE(awaitFullResolution());
  edit([](scene::Scene& scene) { scene.hit.field = scene::Field::cubic; });
  ASSERT_TRUE(waitUntil([&] { return tip().find("hit.field=trilinear") != std::string::npos; })) << tip();
  EXPECT_FALSE(isOn());
  EXPECT_EQ(said().find("Overview: level 2"), 0u) << said();
  edit([](scene::Scene& scene) { scene.hit.field = scene::Field::trilinear; });
  EXPECT_TRUE(awaitFullResolution());
}

TEST_F(FullResolutionViewTest, SavedPicturesAreWhatIsSeen) {
  showLevel(2);
  ASSERT_TRUE(awaitFullResolution());
  const QString saved = newFile("zero.png");
  ASSERT_TRUE(window_->savePicture(saved)) << window_->messageBar()->text().toStdString();
  EXPECT_EQ(app::readSessionText(saved.toStdString()).find("\"level\": 2"), std::string::npos);
  EXPECT_EQ(window_->commandText().toStdString().find("source.level"), std::string::npos);
  const QImage picture(saved);
  EXPECT_LT(differingPixels(picture, zero()->image().convertToFormat(picture.format()), 2), 0.01);
  window_->fullResolutionAction()->trigger();
  const QString level = newFile("level.png");
  ASSERT_TRUE(window_->savePicture(level));
  EXPECT_NE(app::readSessionText(level.toStdString()).find("\"level\": 2"), std::string::npos);
  EXPECT_GT(differingPixels(picture, QImage(level), 8), 0.02);
}

// With the index there, what the overview hides is marked until level 0 is on show.
TEST_F(FullResolutionViewTest, MarksOfTheOverviewComeWithTheIndex) {
  showLevel(2);
  ASSERT_TRUE(awaitFullResolution());
  EXPECT_TRUE(waitUntil([&] { return window_->viewport()->showsOver(Over::structure); }));
  EXPECT_TRUE(isOn()) << "level 0 goes before";
}

}  // namespace
}  // namespace isolux::test
