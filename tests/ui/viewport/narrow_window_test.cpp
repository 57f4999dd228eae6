// The view fits its window, whatever its size, as long as nobody has chosen another one.
#include "tests/support/ui/window_fixture.h"

#include <glm/geometric.hpp>

#include "scene/camera.h"
#include "ui/viewport/viewport.h"
#include "ui/viewport/viewport_overlay.h"

namespace isolux::test {
namespace {

class NarrowWindowTest : public WindowTest {
 protected:
  ui::Viewport* viewport() { return window_->viewport(); }
  std::vector<glm::dvec3> framed() {
    const scene::VolumeFacts& facts = window_->document()->facts();
    if (window_->document()->scene().camera.frames == scene::Frames::surface) return facts.outlineMm;
    std::vector<glm::dvec3> corners;
    for (int i = 0; i < 8; ++i)
      corners.emplace_back(i & 1 ? facts.boundsMaxMm.x : facts.boundsMinMm.x,
                           i & 2 ? facts.boundsMaxMm.y : facts.boundsMinMm.y,
                           i & 4 ? facts.boundsMaxMm.z : facts.boundsMinMm.z);
    return corners;
  }
  // The largest part of the picture's half width and height that something framed is at.
  glm::dvec2 reach() {
    const scene::CameraFrame f = scene::frameOf(window_->document()->resolvedScene().camera);
    const double aspect = static_cast<double>(viewport()->width()) / viewport()->height();
    glm::dvec2 most(0.0);
    for (const glm::dvec3& point : framed()) {
      const glm::dvec3 v = point - f.eye;
      const double scale = f.halfHeight * -glm::dot(v, f.back);
      most.x = std::max(most.x, std::abs(glm::dot(v, f.right)) / (scale * aspect));
      most.y = std::max(most.y, std::abs(glm::dot(v, f.up)) / scale);
    }
    return most;
  }
  void makeNarrow() {
    window_->resize(800, 900);
    ASSERT_TRUE(waitUntil([&] { return viewport()->width() < viewport()->height(); }));
  }
  void makeWide() {
    window_->resize(1200, 640);
    ASSERT_TRUE(waitUntil([&] { return viewport()->width() > 1.3 * viewport()->height(); }));
  }
};

TEST_F(NarrowWindowTest, TheViewFitsItAsLongAsNobodyHasTurnedIt) {
  ASSERT_TRUE(load(*window_, "phantom:head:24"));
  const scene::Scene before = window_->document()->scene();
  ASSERT_GT(framed().size(), 8u);
  makeNarrow();
  EXPECT_EQ(window_->document()->scene(), before) << "nothing is edited";
  for (const auto view : {scene::StandardView::left, scene::StandardView::superior}) {
    EXPECT_LT(reach().x, 0.95) << "clear of the letters, too";
    EXPECT_LE(reach().y, 1.0);
    viewport()->applyStandardView(view);
  }
  EXPECT_LT(reach().x, 0.95);
  viewport()->resetView();
  const scene::Camera narrow = window_->document()->resolvedScene().camera;
  makeWide();
  EXPECT_NE(window_->document()->resolvedScene().camera, narrow);
  EXPECT_LT(reach().x, 0.95);
  EXPECT_LE(reach().y, 1.0);
}

TEST_F(NarrowWindowTest, ItFramesTheSurfaceThatIsExchangedInOneGo) {
  ASSERT_TRUE(load(*window_, "phantom:head:32"));
  ui::Document& document = *window_->document();
  const auto show = [&](double isovalue, const QString& mergeKey) {
    ui::Edit edit{document.scene(), "Show", mergeKey, false};
    edit.scene.surfaces.front().value = isovalue;
    document.edit(edit);
    document.endGesture();
  };
  const scene::Camera bone = document.resolvedScene().camera;
  show(500.0, "isovalue");
  show(600.0, "isovalue");
  EXPECT_EQ(document.resolvedScene().camera, bone) << "it stays while an isovalue is dragged";
  show(-300.0, {});
  const scene::Camera skin = document.resolvedScene().camera;
  EXPECT_GT(glm::distance(*skin.eye, *skin.target), 1.03 * glm::distance(*bone.eye, *bone.target));
  EXPECT_LE(reach().y, 1.0);
  for (int step = 0; step < 3; ++step) document.undo();
  EXPECT_EQ(document.resolvedScene().camera, bone);

  fullPicture(*window_);
  const QPoint centre = viewport()->rect().center();
  drag(viewport(), centre, centre + QPoint(40, 10));
  const scene::Camera chosen = document.resolvedScene().camera;
  show(-300.0, {});
  EXPECT_EQ(document.resolvedScene().camera, chosen) << "somebody has turned it";
  viewport()->resetView();
  EXPECT_EQ(document.resolvedScene().camera, skin);
}

TEST_F(NarrowWindowTest, AViewOfTheVolumeIsInEveryWideWindowTheSame) {
  ASSERT_TRUE(load(*window_, "phantom:head:24"));
  ui::Edit edit{window_->document()->scene(), "Frames", {}, false};
  edit.scene.camera.frames = scene::Frames::volume;
  window_->document()->edit(edit);
  const scene::Scene before = window_->document()->scene();
  const scene::Camera wide = window_->document()->resolvedScene().camera;
  makeNarrow();
  EXPECT_LT(reach().x, 0.95) << "clear of the letters, too";
  EXPECT_LE(reach().y, 1.0);
  EXPECT_EQ(window_->document()->scene(), before) << "nothing is edited";
  for (const auto view : {scene::StandardView::left, scene::StandardView::superior}) {
    viewport()->applyStandardView(view);
    EXPECT_LT(reach().x, 0.95);
  }
  viewport()->resetView();
  makeWide();
  EXPECT_EQ(window_->document()->resolvedScene().camera, wide);
}

TEST_F(NarrowWindowTest, TheLettersAtItsSidesStandBesideTheVolume) {
  ASSERT_TRUE(load(*window_, "phantom:head:24"));
  makeNarrow();
  const ui::ViewportOverlay::Arrangement letters = viewport()->overlay()->arrangement();
  const double half = 0.5 * viewport()->width();
  EXPECT_GT(letters.left.right(), 0.0);
  EXPECT_LT(letters.left.right(), half * (1.0 - reach().x));
  EXPECT_GT(letters.right.left(), half * (1.0 + reach().x));
}

TEST_F(NarrowWindowTest, AViewThatIsChosenStaysAsItIs) {
  ASSERT_TRUE(load(*window_, "phantom:head:24"));
  fullPicture(*window_);
  const QPoint centre = viewport()->rect().center();
  drag(viewport(), centre, centre + QPoint(40, 10));
  const scene::Camera chosen = window_->document()->resolvedScene().camera;
  makeNarrow();
  EXPECT_EQ(window_->document()->resolvedScene().camera, chosen);
}

// What is turned in a narrow window begins as it is seen there.
TEST_F(NarrowWindowTest, TurningBeginsWithTheViewThatIsSeen) {
  ASSERT_TRUE(load(*window_, "phantom:head:24"));
  makeNarrow();
  fullPicture(*window_);
  const double distance = scene::frameOf(window_->document()->resolvedScene().camera).distance;
  const QPoint centre = viewport()->rect().center();
  drag(viewport(), centre, centre + QPoint(40, 10));
  EXPECT_NEAR(scene::frameOf(window_->document()->resolvedScene().camera).distance, distance,
              1e-6 * distance);
}

TEST_F(NarrowWindowTest, TheSavedPictureIsTheOneThatIsSeen) {
  ASSERT_TRUE(load(*window_, "phantom:head:24"));
  makeNarrow();
  ui::Edit edit{window_->document()->scene(), "Words", {}, false};
  edit.scene.picture.letters = edit.scene.picture.scaleBar = edit.scene.picture.isovalue =
      edit.scene.picture.caveats = false;
  window_->document()->edit(edit);
  const QImage seen = fullPicture(*window_);
  const QString file = newFile("narrow.png");
  ASSERT_TRUE(window_->savePicture(file));
  EXPECT_EQ(differingPixels(seen, QImage(file)), 0.0);
  EXPECT_TRUE(window_->commandText().contains("camera.eye")) << window_->commandText().toStdString();
}

TEST_F(NarrowWindowTest, TheScaleBarMakesWayForALegendThatLiesOverThePicture) {
  ASSERT_TRUE(load(*window_, "phantom:head:24"));
  const QImage seen = fullPicture(*window_);
  const ui::ViewportOverlay& overlay = *viewport()->overlay();
  const QRectF before = overlay.arrangement().scale;
  const QRectF legend(8.0, seen.height() - 168.0, 150.0, 160.0);
  viewport()->setOver(ui::Viewport::Over::errors, seen, seen, render::Tile{{8, 8}, {150, 160}});
  ASSERT_EQ(viewport()->devicePixelRatioF(), 1.0);
  EXPECT_TRUE(before.intersects(legend));
  EXPECT_FALSE(overlay.arrangement().scale.intersects(legend));
  viewport()->setOver(ui::Viewport::Over::errors, {}, seen);
  EXPECT_EQ(overlay.arrangement().scale, before);
}

}  // namespace
}  // namespace isolux::test
