// Errors laid over the picture on screen: those of that picture and no other, while the Accuracy panel is
// seen.
#include <QComboBox>
#include <QCoreApplication>

#include "scene/settings/settings.h"
#include "tests/support/ui/window_fixture.h"
#include "ui/accuracy/accuracy_panel.h"
#include "ui/accuracy/error_overlay_box.h"
#include "ui/accuracy/target_box.h"
#include "ui/viewport/viewport.h"

namespace isolux::test {
namespace {

class ErrorOverlayTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    ASSERT_TRUE(load(*window_, "phantom:torus:24"));
    window_->showPanel("Accuracy");
  }
  ui::AccuracyPanel* panel() { return window_->panel<ui::AccuracyPanel>(); }
  void choose(std::optional<app::ErrorImage> error) { panel()->overlay()->choose(error); }
  bool awaitOverlay() {
    return waitUntil(
        [&] {
          return window_->viewport()->showsOver(ui::Viewport::Over::errors) && !panel()->overlay()->working();
        },
        120000);
  }
  QImage onScreen() {
    QCoreApplication::processEvents();
    return window_->viewport()->grab().toImage();
  }
  void edit(const char* assignment) {
    ui::Edit edit{window_->document()->scene(), assignment, {}, false};
    scene::applyAssignment(edit.scene, assignment);
    window_->document()->edit(edit);
  }
};

TEST_F(ErrorOverlayTest, LiesOverThePictureThatItIsOfAndNoOther) {
  fullPicture(*window_);
  const QImage plain = onScreen();
  choose(app::ErrorImage::depth);
  ASSERT_TRUE(awaitOverlay()) << panel()->state().toStdString();
  const QImage depth = onScreen();
  EXPECT_GT(differingPixels(plain, depth, 20), 0.02);
  choose(app::ErrorImage::normal);
  ASSERT_TRUE(awaitOverlay());
  EXPECT_GT(differingPixels(depth, onScreen(), 20), 0.001) << "another error has another legend";

  edit("camera.fov=40");
  EXPECT_TRUE(waitUntil([&] { return !window_->viewport()->showsOver(ui::Viewport::Over::errors); }));
  fullPicture(*window_);
  EXPECT_TRUE(awaitOverlay()) << "of the new picture";
  choose(std::nullopt);
  EXPECT_FALSE(window_->viewport()->showsOver(ui::Viewport::Over::errors));
  window_->document()->undo();
  fullPicture(*window_);
  EXPECT_LT(differingPixels(plain, onScreen(), 20), 0.001);
}

TEST_F(ErrorOverlayTest, WhatExceedsTheErrorThatIsEnteredIsHatched) {
  choose(app::ErrorImage::normal);
  panel()->findChild<ui::TargetBox*>()->askError(app::Quantity::normal, 90.0);
  ASSERT_TRUE(awaitOverlay());
  const QImage without = onScreen();
  panel()->findChild<ui::TargetBox*>()->askError(app::Quantity::normal, 1e-9);
  EXPECT_TRUE(waitUntil([&] { return differingPixels(without, onScreen(), 40) > 0.02; }));
  panel()->findChild<ui::TargetBox*>()->askTime(100.0);
  EXPECT_TRUE(waitUntil([&] { return differingPixels(without, onScreen(), 40) < 0.02; }));
}

TEST_F(ErrorOverlayTest, WithoutStoredLightItSaysWhatToDo) {
  choose(app::ErrorImage::light);
  ASSERT_TRUE(waitUntil([&] { return !panel()->overlay()->note().isEmpty(); }, 120000));
  EXPECT_FALSE(window_->viewport()->showsOver(ui::Viewport::Over::errors));
  EXPECT_TRUE(panel()->overlay()->note().contains("Global illumination"));
}

TEST_F(ErrorOverlayTest, GoesWithThePanel) {
  choose(app::ErrorImage::depth);
  ASSERT_TRUE(awaitOverlay());
  window_->showPanel("Passes");
  EXPECT_TRUE(waitUntil([&] { return !window_->viewport()->showsOver(ui::Viewport::Over::errors); }));
}

}  // namespace
}  // namespace isolux::test
