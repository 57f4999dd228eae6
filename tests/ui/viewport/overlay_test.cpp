// What stands over the picture keeps clear of itself, of legends and of lines.
#include "ui/viewport/viewport_overlay.h"

#include <QLineF>

#include <gtest/gtest.h>

#include "scene/rules/automatic.h"

namespace isolux::test {
namespace {

scene::VolumeFacts headFacts() {
  scene::VolumeFacts facts;
  facts.boundsMinMm = {-100.0, -120.0, -90.0};
  facts.boundsMaxMm = {100.0, 120.0, 110.0};
  facts.axes = scene::WorldAxes::anatomical;
  return facts;
}

void expectClear(const ui::ViewportOverlay& overlay, const std::vector<QRectF>& taken) {
  std::vector<QRectF> boxes = overlay.arrangement().boxes();
  for (const QRectF& box : boxes)
    EXPECT_TRUE(QRectF(overlay.rect()).contains(box)) << box.x() << ' ' << box.y();
  boxes.insert(boxes.end(), taken.begin(), taken.end());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_FALSE(boxes[i].intersects(boxes[j]))
          << i << " and " << j << ": " << boxes[i].x() << ' ' << boxes[i].y() << ", " << boxes[j].x() << ' '
          << boxes[j].y();
}

TEST(OverlayTest, LettersCubeAndScaleKeepClearOfLegendsAtAnySize) {
  const scene::Scene resolved = scene::resolve({}, headFacts());
  for (const QSize size :
       {QSize(240, 180), QSize(264, 480), QSize(427, 430), QSize(452, 278), QSize(1000, 700)}) {
    ui::ViewportOverlay overlay(nullptr);
    overlay.resize(size);
    overlay.setScene(resolved, true, scene::WorldAxes::anatomical);
    expectClear(overlay, {});
    const QSizeF legend(0.4 * size.width(), 0.45 * size.height());
    for (const double x : {8.0, size.width() - 8.0 - legend.width()})
      for (const double y : {8.0, size.height() - 8.0 - legend.height()}) {
        SCOPED_TRACE(std::to_string(size.width()) + " legend at " + std::to_string(x) + ' ' +
                     std::to_string(y));
        const std::vector<QRectF> taken{QRectF({x, y}, legend)};
        overlay.setTaken(taken);
        expectClear(overlay, taken);
      }
  }
}

TEST(OverlayTest, LettersStandBesideTheOutlinesOfSlices) {
  scene::Scene scene;
  scene.camera.eye = glm::dvec3(0.0, -600.0, 10.0);
  scene.camera.target = glm::dvec3(0.0, 0.0, 10.0);
  const scene::Scene resolved = scene::resolve(scene, headFacts());
  ui::ViewportOverlay overlay(nullptr);
  overlay.resize(452, 278);
  overlay.setScene(resolved, true, scene::WorldAxes::anatomical);
  const ui::ViewportOverlay::Arrangement before = overlay.arrangement();
  EXPECT_NEAR(before.top.center().x(), 226.0, 1.0);
  ui::SlicesInPicture slices;
  slices.outlines = {{{{0, -120, -150}, {0, 120, -150}, {0, 120, 170}, {0, -120, 170}}, Qt::yellow}};
  overlay.setSlices(slices);
  const ui::ViewportOverlay::Arrangement beside = overlay.arrangement();
  for (const QRectF& letter : {beside.top, beside.bottom}) {
    EXPECT_GT(std::abs(letter.center().x() - 226.0), 0.5 * letter.width());
    EXPECT_LT(std::abs(letter.center().x() - 226.0), 40.0) << "as near as can be";
    for (const QLineF& line : ui::sliceLines(slices, scene::frameOf(resolved.camera), overlay.size()))
      for (const QLineF& diagonal :
           {QLineF(letter.topLeft(), letter.bottomRight()), QLineF(letter.bottomLeft(), letter.topRight())})
        EXPECT_NE(line.intersects(diagonal, nullptr), QLineF::BoundedIntersection);
  }
}

TEST(OverlayTest, ANoteThatIsTooWideIsBrokenBetweenWords) {
  ui::ViewportOverlay overlay(nullptr);
  overlay.resize(264, 480);
  overlay.setScene(scene::resolve({}, headFacts()), true, scene::WorldAxes::anatomical);
  overlay.setNote("No surface at 999: the data range is -0.0224431 to 0.0224431");
  const ui::ViewportOverlay::Arrangement found = overlay.arrangement();
  EXPECT_LE(found.note.width(), 264.0 - 24.0);
  EXPECT_GT(found.note.height(), 1.5 * overlay.fontMetrics().lineSpacing());
  expectClear(overlay, {});
}

}  // namespace
}  // namespace isolux::test
