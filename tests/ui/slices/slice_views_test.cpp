// Slices beside the picture: what they show, and what the mouse does in them.
#include <cmath>

#include <QAction>
#include <QTest>

#include <glm/geometric.hpp>

#include "tests/support/ui/window_fixture.h"
#include "ui/slices/slice_board.h"
#include "ui/viewport/viewport.h"

namespace isolux::test {
namespace {

using ui::SliceView;
using volume::SliceDirection;

class SliceViewsTest : public WindowTest {
 protected:
  SliceView* view(SliceDirection direction) { return window_->slices()->view(direction); }
  bool loadFourUp(const QString& path) {
    if (!load(*window_, path)) return false;
    window_->slices()->setFourUp(true);
    return complete();
  }
  bool complete() {
    return waitUntil([&] {
      for (const SliceDirection d :
           {SliceDirection::axial, SliceDirection::coronal, SliceDirection::sagittal})
        if (!view(d)->complete() || view(d)->shown().isNull()) return false;
      return true;
    });
  }
  const scene::Scene& scene() { return window_->document()->scene(); }
  std::size_t steps() {  // that can be undone
    std::size_t count = 0;
    for (; window_->document()->history().canUndo(); ++count) window_->document()->undo();
    for (std::size_t i = 0; i < count; ++i) window_->document()->redo();
    return count;
  }
};

TEST_F(SliceViewsTest, AKeyShowsThemAndTakesThemAway) {
  ASSERT_TRUE(load(*window_, "phantom:ball:32"));
  EXPECT_FALSE(view(SliceDirection::axial)->isVisible());
  const QSize alone = window_->viewport()->size();
  QTest::keyClick(window_.get(), Qt::Key_F4);
  ASSERT_TRUE(complete());
  for (const SliceDirection d : {SliceDirection::axial, SliceDirection::coronal, SliceDirection::sagittal}) {
    EXPECT_TRUE(view(d)->isVisible());
    EXPECT_GT(view(d)->width(), alone.width() / 3);
    EXPECT_GT(view(d)->height(), alone.height() / 3);
  }
  EXPECT_LT(window_->viewport()->width(), alone.width() * 2 / 3);
  QTest::keyClick(window_.get(), Qt::Key_F4);
  EXPECT_TRUE(waitUntil([&] { return window_->viewport()->size() == alone; }));
  EXPECT_FALSE(view(SliceDirection::sagittal)->isVisible());
}

// The ball's circle stands about the crosshair, in the surface's colour.
TEST_F(SliceViewsTest, ShowTheSurfacesCurve) {
  ASSERT_TRUE(loadFourUp("phantom:ball:32"));
  ui::Edit edit{scene(), "Colour", {}, false};
  edit.scene.isosurface.albedo = {1.0, 0.0, 0.0};
  window_->document()->edit(edit);
  ASSERT_TRUE(complete());
  const double radius = 0.35 * 31.0;
  for (const SliceDirection d : {SliceDirection::axial, SliceDirection::coronal, SliceDirection::sagittal}) {
    const auto frame = view(d)->plane()->frame();
    const QImage& image = view(d)->shown();
    for (int i = 0; i < 16; ++i) {
      const double angle = 2.0 * 3.141592653589793 * i / 16.0 + 0.1;
      const auto colorAt = [&](double r) {
        const glm::dvec2 pixel = view(d)->plane()->pixelOf(
            view(d)->position() + r * (std::cos(angle) * frame.right + std::sin(angle) * frame.down));
        return image.pixelColor(static_cast<int>(std::lround(pixel.x)),
                                static_cast<int>(std::lround(pixel.y)));
      };
      EXPECT_GT(colorAt(radius).red(), colorAt(radius).green() + 60) << i;
      EXPECT_EQ(colorAt(radius - 3.0).red(), colorAt(radius - 3.0).green()) << i;
    }
  }
}

TEST_F(SliceViewsTest, ADragMovesTheCrosshairInOneStepAndTheOthersFollow) {
  ASSERT_TRUE(loadFourUp("phantom:head:32"));
  SliceView* const axial = view(SliceDirection::axial);
  const glm::dvec3 before = axial->position();
  const std::size_t done = steps();
  const glm::dvec3 target = before + glm::dvec3(20.0, -15.0, 0.0);
  drag(axial, axial->placeOf(before).toPoint(), axial->placeOf(target).toPoint());
  EXPECT_EQ(steps(), done + 1);
  ASSERT_TRUE(scene().slice.position.has_value());
  const double pixel = axial->plane()->pixelMm();
  EXPECT_LT(glm::distance(*scene().slice.position, target), 2.0 * pixel);
  EXPECT_EQ(scene().slice.position->z, before.z);
  ASSERT_TRUE(complete());
  const auto coronal = view(SliceDirection::coronal)->plane(),
             sagittal = view(SliceDirection::sagittal)->plane();
  EXPECT_NEAR(coronal->originMm.y, scene().slice.position->y, 1e-9);
  EXPECT_NEAR(sagittal->originMm.x, scene().slice.position->x, 1e-9);
  window_->document()->undo();
  EXPECT_FALSE(scene().slice.position.has_value());
}

TEST_F(SliceViewsTest, TheWheelStepsByAVoxelAndStaysInTheVolume) {
  ASSERT_TRUE(loadFourUp(writeBall(24, {1.0, 1.0, 2.5})));
  SliceView* const axial = view(SliceDirection::axial);
  const double z = axial->position().z;
  wheel(axial, axial->rect().center(), 2);
  EXPECT_TRUE(waitUntil([&] { return std::abs(axial->position().z - z) > 1e-9; }));
  EXPECT_NEAR(std::abs(axial->position().z - z), 5.0, 1e-9);
  wheel(axial, axial->rect().center(), 100);
  glm::dvec3 low, high;
  window_->document()->volume()->grid().geometry().worldBounds(low, high);
  EXPECT_LE(axial->position().z, high.z);
  EXPECT_GE(axial->position().z, low.z);
}

TEST_F(SliceViewsTest, ARightDragChangesLevelAndWidthInOneStep) {
  ASSERT_TRUE(loadFourUp("phantom:ball:32"));
  SliceView* const coronal = view(SliceDirection::coronal);
  const QImage before = coronal->shown();
  const std::size_t done = steps();
  const QPoint middle = coronal->rect().center();
  drag(coronal, middle, middle + QPoint(-60, 30), Qt::RightButton);
  EXPECT_EQ(steps(), done + 1);
  ASSERT_TRUE(scene().slice.level && scene().slice.width);
  ASSERT_TRUE(complete());
  EXPECT_GT(differingPixels(before, coronal->shown()), 0.1);
}

TEST_F(SliceViewsTest, ZoomKeepsThePointUnderThePointer) {
  ASSERT_TRUE(loadFourUp("phantom:head:32"));
  SliceView* const sagittal = view(SliceDirection::sagittal);
  const QPoint place = sagittal->rect().center() + QPoint(40, 25);
  const auto under = [&] {
    return sagittal->plane()->at((glm::dvec2(place.x(), place.y()) + 0.0) * sagittal->devicePixelRatioF() -
                                 0.5);
  };
  const glm::dvec3 before = under();
  const double pixel = sagittal->plane()->pixelMm();
  wheel(sagittal, place, 3, Qt::ControlModifier);
  EXPECT_LT(sagittal->plane()->pixelMm(), 0.6 * pixel);
  EXPECT_LT(glm::distance(under(), before), 0.5 * pixel);
  EXPECT_TRUE(complete());
  QTest::mouseDClick(sagittal, Qt::LeftButton, {}, place);
  EXPECT_NEAR(sagittal->plane()->pixelMm(), pixel, 1e-12);
}

TEST_F(SliceViewsTest, TheConventionTurnsThemAtOnce) {
  ASSERT_TRUE(loadFourUp("phantom:head:32"));
  EXPECT_GT(view(SliceDirection::axial)->plane()->rightMm.x, 0.0);
  const QImage before = view(SliceDirection::coronal)->shown();
  ui::Edit edit{scene(), "Convention", {}, false};
  edit.scene.slice.convention = scene::Convention::neurological;
  window_->document()->edit(edit);
  EXPECT_LT(view(SliceDirection::axial)->plane()->rightMm.x, 0.0);
  ASSERT_TRUE(complete());
  EXPECT_GT(differingPixels(before, view(SliceDirection::coronal)->shown()), 0.001);
}

}  // namespace
}  // namespace isolux::test
