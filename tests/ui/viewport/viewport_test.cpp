// The mouse in the picture: what is under the pointer follows it, and every gesture is one step.
#include "tests/support/ui/window_fixture.h"

#include <cmath>
#include <utility>

#include <QMouseEvent>
#include <QTest>
#include <QThread>

#include <glm/geometric.hpp>

#include "scene/camera.h"
#include "ui/document/preferences.h"
#include "ui/viewport/viewport.h"

namespace isolux::test {

namespace {

// Where the mouse was last seen by a widget: moves come from the X server, when it pleases.
class LastMove : public QObject {
 public:
  explicit LastMove(QWidget* widget) { widget->installEventFilter(this); }
  QPoint position() const { return position_; }
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == QEvent::MouseMove)
      position_ = static_cast<QMouseEvent*>(event)->position().toPoint();
    return false;
  }

 private:
  QPoint position_{-1, -1};
};

class ViewportTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    ASSERT_TRUE(load(*window_, "phantom:ball:48"));
    fullPicture(*window_);
  }
  ui::Viewport* viewport() { return window_->viewport(); }
  QPoint centre() { return viewport()->rect().center(); }
  scene::CameraFrame frame() { return scene::frameOf(window_->document()->resolvedScene().camera); }
  std::string lastStep() { return window_->document()->history().undoName(); }

  // The surface point under a pixel, as the status bar gets it.
  std::optional<app::Pick> pointAt(QPoint position) {
    std::optional<app::Pick> result;
    bool reported = false;
    const LastMove lastMove(viewport());
    const auto connection =
        QObject::connect(viewport(), &ui::Viewport::pointed, [&](const std::optional<app::Pick>& pick) {
          if (lastMove.position() != position) return;  // a report of an earlier place
          result = pick;
          reported = true;
        });
    QTest::mouseMove(viewport(), position + QPoint(1, 0));
    QTest::mouseMove(viewport(), position);
    EXPECT_TRUE(waitUntil([&] { return reported; }));
    QObject::disconnect(connection);
    return result;
  }
  QPointF onScreen(glm::dvec3 world) {
    const scene::CameraFrame f = frame();
    const glm::dvec3 v = world - f.eye;
    const double scale = 0.5 * viewport()->height() / (f.halfHeight * -glm::dot(v, f.back));
    return QPointF(0.5 * viewport()->width() + scale * glm::dot(v, f.right),
                   0.5 * viewport()->height() - scale * glm::dot(v, f.up));
  }
};

}  // namespace

// A picture is there at once; that at the scale follows when its field is made, and is saved only then.
TEST_F(ViewportTest, APictureAtAScaleComesWhenItsFieldIsThere) {
  ASSERT_TRUE(load(*window_, "phantom:head:96"));
  ui::Edit edit{window_->document()->scene(), "Curvature", {}, false};
  edit.scene.look.mode = scene::LookMode::kappa1;
  edit.scene.derivatives.scale = edit.scene.derivatives.normalScale = 0.0;
  window_->document()->edit(edit);
  const QImage unscaled = fullPicture(*window_);
  bool complete = true;  // the first picture that is drawn
  int pictures = 0;
  const auto connection = QObject::connect(viewport(), &ui::Viewport::drawn, [&](double, bool isComplete) {
    if (pictures++ == 0) complete = isComplete;
  });
  edit.scene.derivatives.scale = 6.0;
  window_->document()->edit(edit);
  ASSERT_TRUE(waitUntil([&] { return pictures > 0; }));
  EXPECT_FALSE(complete);
  const QImage scaled = fullPicture(*window_);
  QObject::disconnect(connection);
  EXPECT_GT(differingPixels(unscaled, scaled), 0.02);
  EXPECT_EQ(viewport()->picture({}).color.size, glm::ivec2(scaled.width(), scaled.height()));
  edit.scene.derivatives.scale = 0.0;
  window_->document()->edit(edit);
  EXPECT_EQ(differingPixels(unscaled, fullPicture(*window_), 0), 0.0);
}

TEST_F(ViewportTest, ARestingPointerReadsTheNewPicture) {
  const auto before = pointAt(centre());
  ASSERT_TRUE(before);
  std::optional<app::Pick> latest = before;
  const auto connection = QObject::connect(viewport(), &ui::Viewport::pointed,
                                           [&](const std::optional<app::Pick>& pick) { latest = pick; });
  QTest::keyClick(window_.get(), Qt::Key_2);  // the other side comes under the pointer
  EXPECT_TRUE(waitUntil([&] { return latest && glm::distance(latest->worldMm, before->worldMm) > 1.0; }));
  QObject::disconnect(connection);
}

TEST_F(ViewportTest, PointerReadsTheSurfaceAtItsPosition) {
  const auto pick = pointAt(centre() + QPoint(20, 10));
  ASSERT_TRUE(pick.has_value());
  const double isovalue = *window_->document()->resolvedScene().surfaces.front().value;
  const auto& volume = window_->document()->volume();
  EXPECT_NEAR(pick->value, isovalue, 1e-3 * (volume->grid().maximum() - volume->grid().minimum()));
  const QPointF back = onScreen(pick->worldMm) - QPointF(centre() + QPoint(20, 10));
  EXPECT_LT(std::hypot(back.x(), back.y()), 1.5);
  EXPECT_FALSE(pointAt(QPoint(3, 3)).has_value());
}

TEST_F(ViewportTest, LeftDragTurnsTheSurfaceUnderThePointer) {
  const auto front = pointAt(centre());
  ASSERT_TRUE(front.has_value());
  const scene::CameraFrame before = frame();
  drag(viewport(), centre(), centre() + QPoint(40, 0));
  EXPECT_GT(onScreen(front->worldMm).x(), centre().x() + 5.0);  // to the right, like the pointer
  EXPECT_NEAR(frame().distance, before.distance, 1e-6);
  EXPECT_EQ(lastStep(), "Rotate");
  window_->document()->undo();
  EXPECT_FALSE(window_->document()->history().canUndo());  // one drag, one step
  drag(viewport(), centre(), centre() + QPoint(0, 40));
  EXPECT_GT(onScreen(front->worldMm).y(), centre().y() + 5.0);
}

TEST_F(ViewportTest, MiddleAndShiftDragPanByExactlyTheDrag) {
  const glm::dvec3 target = *window_->document()->resolvedScene().camera.target;
  drag(viewport(), centre(), centre() + QPoint(60, -30), Qt::MiddleButton);
  EXPECT_EQ(lastStep(), "Pan");
  EXPECT_NEAR(onScreen(target).x(), 0.5 * viewport()->width() + 60.0, 0.5);
  EXPECT_NEAR(onScreen(target).y(), 0.5 * viewport()->height() - 30.0, 0.5);
  drag(viewport(), centre(), centre() + QPoint(-60, 30), Qt::LeftButton, Qt::ShiftModifier);
  EXPECT_NEAR(onScreen(target).x(), 0.5 * viewport()->width(), 0.5);
}

TEST_F(ViewportTest, RightDragAndWheelZoom) {
  const double start = frame().distance;
  drag(viewport(), centre(), centre() - QPoint(0, 60), Qt::RightButton);
  EXPECT_LT(frame().distance, 0.9 * start);
  const double near = frame().distance;
  wheel(viewport(), centre(), -2);
  EXPECT_NEAR(frame().distance, near * 1.21, 1e-3 * near);
  wheel(viewport(), centre(), -1);
  EXPECT_EQ(lastStep(), "Zoom");
  window_->document()->undo();  // the wheel's notches are one step
  EXPECT_NEAR(frame().distance, near, 1e-6 * near);
}

TEST_F(ViewportTest, ControlDragRollsWithThePointer) {
  const glm::dvec3 up = frame().up, right = frame().right;
  drag(viewport(), centre() + QPoint(0, -100), centre() + QPoint(100, 0), Qt::LeftButton, Qt::ControlModifier,
       20);
  EXPECT_EQ(lastStep(), "Roll");
  // The picture turned a quarter clockwise: what was up is now at the right.
  EXPECT_NEAR(glm::dot(frame().right, up), 1.0, 0.02);
  EXPECT_NEAR(glm::dot(frame().up, right), -1.0, 0.02);
}

TEST_F(ViewportTest, DoubleClickCentresThePointAndKeepsTheDirection) {
  const QPoint position = centre() + QPoint(30, -20);
  const auto pick = pointAt(position);
  ASSERT_TRUE(pick.has_value());
  const glm::dvec3 back = frame().back;
  QTest::mouseDClick(viewport(), Qt::LeftButton, Qt::NoModifier, position);
  EXPECT_NEAR(glm::distance(*window_->document()->scene().camera.target, pick->worldMm), 0.0, 1e-3);
  EXPECT_NEAR(glm::dot(frame().back, back), 1.0, 1e-9);
}

TEST_F(ViewportTest, StandardViewsResetAndProjection) {
  const scene::Scene start = window_->document()->scene();
  QTest::keyClick(window_.get(), Qt::Key_3);
  EXPECT_NEAR(frame().back.x, 1.0, 1e-9);  // the viewer stands at +x
  EXPECT_EQ(lastStep(), "+X view");        // a ball has no left
  QTest::keyClick(window_.get(), Qt::Key_O);
  EXPECT_EQ(window_->document()->scene().camera.projection, scene::Projection::orthographic);
  QTest::keyClick(window_.get(), Qt::Key_O);
  QTest::keyClick(window_.get(), Qt::Key_R);
  EXPECT_EQ(window_->document()->scene(), start);
}

TEST_F(ViewportTest, PicturesInMotionAreRefinedWhenItRests) {
  drag(viewport(), centre(), centre() + QPoint(10, 0));
  EXPECT_FALSE(viewport()->complete());
  EXPECT_TRUE(waitUntil([&] { return viewport()->complete(); }));
  // Also when the window was too busy to draw the quick picture in between.
  scene::Scene scene = window_->document()->scene(), resolved = window_->document()->resolvedScene();
  scene.camera.fov = resolved.camera.fov = 31.0;
  viewport()->setScene(scene, resolved);
  QThread::msleep(300);  // nothing but time: the window is busy
  EXPECT_FALSE(viewport()->complete());
  EXPECT_TRUE(waitUntil([&] { return viewport()->complete(); }));
}

// A busy machine: what was quick enough in motion is no longer, but is already what the stage after it asks
// for.
TEST_F(ViewportTest, APictureInMotionOfTheFullSizeIsRefinedToo) {
  scene::Scene scene = window_->document()->scene(), resolved = window_->document()->resolvedScene();
  const auto draw = [&](double fov, int supersampling, double target) {
    scene.camera.fov = resolved.camera.fov = fov;
    scene.picture.supersampling = resolved.picture.supersampling = supersampling;
    scene::HostSettings host = ui::savedHostSettings();
    host.motionTarget = target;
    viewport()->setHostSettings(host);
    viewport()->setScene(scene, resolved);
  };
  draw(31.0, 1, 2000.0);  // what is in motion grows to the full size
  fullPicture(*window_);
  bool fullSizeInMotion = false;
  const auto connection = QObject::connect(
      viewport(), &ui::Viewport::reported,
      [&, first = true](const render::FrameReport&, const render::FrameRequest& request) mutable {
        const double ratio = viewport()->devicePixelRatioF();
        if (std::exchange(first, false))
          fullSizeInMotion =
              request.supersampling == 1 && request.size.x >= viewport()->width() * ratio - 1.0;
      });
  draw(32.0, 2, 5.0);
  fullPicture(*window_);
  QObject::disconnect(connection);
  EXPECT_TRUE(fullSizeInMotion);
}

}  // namespace isolux::test
