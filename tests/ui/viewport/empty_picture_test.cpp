// A picture in which nothing is to be seen says why, and what it offers helps.
#include "tests/support/ui/window_fixture.h"

#include <QPushButton>
#include <QTest>

#include "ui/viewport/viewport.h"
#include "ui/viewport/viewport_overlay.h"
#include "ui/window/message_bar.h"

namespace isolux::test {

namespace {

class EmptyPictureTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    ASSERT_TRUE(load(*window_, "phantom:ball:24"));
    full_ = fullPicture(*window_);
  }
  QPushButton* remedy() { return window_->viewport()->findChild<QPushButton*>("remedy"); }
  QString said() { return window_->viewport()->findChild<ui::ViewportOverlay*>()->accessibleDescription(); }
  void expectTheRemedyHelps() {
    ASSERT_TRUE(remedy()->isVisible());
    QTest::mouseClick(remedy(), Qt::LeftButton);
    EXPECT_EQ(differingPixels(full_, fullPicture(*window_), 0), 0.0);
    EXPECT_FALSE(remedy()->isVisible());
    EXPECT_TRUE(said().isEmpty()) << said().toStdString();
  }
  QImage full_;
};

}  // namespace

TEST_F(EmptyPictureTest, AnIsovalueOutsideTheValues) {
  EXPECT_FALSE(remedy()->isVisible());
  ui::Edit edit{window_->document()->scene(), "Isovalue", {}, false};
  edit.scene.surfaces.front().value = 5000.0;
  window_->document()->edit(edit);
  fullPicture(*window_);
  EXPECT_TRUE(said().startsWith("No surface at 5000: the data range is -")) << said().toStdString();
  expectTheRemedyHelps();
}

TEST_F(EmptyPictureTest, ACameraThatLooksAway) {
  ui::Edit edit{window_->document()->scene(), "Camera", {}, false};
  const scene::Camera seen = window_->document()->resolvedScene().camera;
  const glm::dvec3 eye = seen.eye.value(), target = seen.target.value();
  edit.scene.camera.eye = eye;
  edit.scene.camera.up = seen.up;
  edit.scene.camera.target = eye + (eye - target);
  window_->document()->edit(edit);
  fullPicture(*window_);
  EXPECT_EQ(said(), "The camera looks away from the volume");
  expectTheRemedyHelps();
}

TEST_F(EmptyPictureTest, ASurfaceThatIsFullyTransparent) {
  ui::Edit edit{window_->document()->scene(), "Opacity", {}, false};
  edit.scene.surfaces.front().opacity = 0.0;
  window_->document()->edit(edit);
  fullPicture(*window_);
  EXPECT_EQ(said(), "The isosurface is fully transparent");
  expectTheRemedyHelps();
}

TEST_F(EmptyPictureTest, PiecesThatAreAllHidden) {
  ui::Edit edit{window_->document()->scene(), "Pieces", {}, false};
  edit.scene.pieces.smallest = 1e9;  // mm^3
  window_->document()->edit(edit);
  fullPicture(*window_);
  EXPECT_EQ(said(), "All connected components that would be visible here are hidden");
  EXPECT_EQ(remedy()->text(), "Show all pieces");
  expectTheRemedyHelps();
}

TEST_F(EmptyPictureTest, CutsThatLeaveNothing) {
  ui::Edit edit{window_->document()->scene(), "Cut", {}, false};
  edit.scene.clip.planes = {{glm::dvec3(0.0, 0.0, -1000.0), glm::dvec3(0.0, 0.0, 1.0)}};
  window_->document()->edit(edit);
  fullPicture(*window_);
  EXPECT_EQ(said(), "The cuts remove all of the surface");
  EXPECT_EQ(remedy()->text(), "Remove the cuts");
  expectTheRemedyHelps();
}

}  // namespace isolux::test
