// Looks and presets as small pictures of the present scene.
#include "ui/presets/looks_panel.h"

#include <cmath>
#include <fstream>
#include <set>

#include <QListWidget>
#include <QMouseEvent>
#include <QSlider>
#include <QTest>

#include "tests/support/ui/window_fixture.h"
#include "ui/presets/thumbnail_painter.h"
#include "ui/viewport/viewport.h"

namespace isolux::test {

namespace {

QListWidgetItem* itemNamed(QListWidget* list, const QString& text) {
  const QList<QListWidgetItem*> found = list->findItems(text, Qt::MatchExactly);
  return found.empty() ? nullptr : found.front();
}

QPoint centreOfItem(QListWidgetItem* item) {
  return item->listWidget()->visualItemRect(item).center();
}

class LooksPanelTest : public WindowTest {
 protected:
  void open(const QString& path) {
    ASSERT_TRUE(load(*window_, path));
    window_->showPanel("Looks");
    panel_ = window_->panel<ui::LooksPanel>();
    ASSERT_TRUE(waitUntil([this] { return panel_->isVisible() && panel_->presetList()->count() > 0; }));
  }
  bool pictured() {
    return waitUntil([this] { return panel_->painter().complete() && panel_->painter().drawnCount() > 0; },
                     60000);
  }
  void pointTo(QListWidgetItem* item) {
    // Sent, not moved: the item may be scrolled out of sight.
    QWidget* const view = item->listWidget()->viewport();
    const QPointF at = centreOfItem(item);
    QMouseEvent move(QEvent::MouseMove, at, view->mapToGlobal(at), Qt::NoButton, Qt::NoButton,
                     Qt::NoModifier);
    QCoreApplication::sendEvent(view, &move);
  }
  ui::LooksPanel* panel_ = nullptr;
};

}  // namespace

TEST_F(LooksPanelTest, APresetThatCannotApplyIsDimAndSaysWhy) {
  open("phantom:ball:16");
  QListWidgetItem* const bone = itemNamed(panel_->presetList(), "CT bone");
  ASSERT_NE(bone, nullptr);
  EXPECT_FALSE(bone->flags() & Qt::ItemIsEnabled);
  EXPECT_TRUE(bone->toolTip().contains("it is no CT")) << bone->toolTip().toStdString();
  const scene::Scene before = window_->document()->scene();
  QTest::mouseClick(panel_->presetList()->viewport(), Qt::LeftButton, Qt::NoModifier, centreOfItem(bone));
  EXPECT_EQ(window_->document()->scene(), before);
}

// Another patient's pictures are gone in the turn in which the volume changes.
TEST_F(LooksPanelTest, AnotherVolumeHasNoPicturesAtFirst) {
  open("phantom:head:24");
  fullPicture(*window_);
  ASSERT_TRUE(pictured());
  const auto colours = [&] {
    std::set<QRgb> found;
    const QListWidget* const list = panel_->lookList();
    for (int i = 0; i < list->count(); ++i) {
      const QImage image = list->item(i)->icon().pixmap(list->iconSize()).toImage();
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) found.insert(image.pixel(x, y));
    }
    return found.size();
  };
  ASSERT_GT(colours(), 100u);
  std::size_t atOnce = 0;
  QObject::connect(window_->document(), &ui::Document::volumeChanged, [&] { atOnce = colours(); });
  ASSERT_TRUE(load(*window_, "phantom:torus:16"));
  EXPECT_EQ(atOnce, 1u);
}

// Pictures are those of the scenes, drawn at rest, and kept.
TEST_F(LooksPanelTest, PicturesAreDrawnAtRestAndKept) {
  open("phantom:head:24");
  fullPicture(*window_);
  ASSERT_TRUE(pictured());
  const int drawn = panel_->painter().drawnCount();
  std::set<qint64> different;
  int there = 0;
  for (std::size_t i = 0; i < panel_->thumbnails().size(); ++i) {
    const QImage* const image = panel_->painter().picture(i);
    EXPECT_EQ(image != nullptr, panel_->thumbnails()[i].why.empty()) << panel_->thumbnails()[i].name;
    if (!image) continue;
    ++there;
    uint hash = 0;
    for (int y = 0; y < image->height(); ++y)
      for (int x = 0; x < image->width(); ++x) hash = hash * 31 + image->pixel(x, y);
    different.insert(hash);
  }
  EXPECT_EQ(there, drawn);
  EXPECT_GE(static_cast<int>(different.size()), there - 3) << "each shows something else";

  // Another scene and back: those of before are still there.
  ui::Edit edit{window_->document()->scene(), "Change albedo", {}, false};
  edit.scene.surfaces.front().albedo = {0.2, 0.5, 0.9};
  window_->document()->edit(edit);
  fullPicture(*window_);
  ASSERT_TRUE(pictured());
  const int more = panel_->painter().drawnCount();
  EXPECT_GT(more, drawn);
  window_->document()->undo();
  fullPicture(*window_);
  ASSERT_TRUE(pictured());
  EXPECT_EQ(panel_->painter().drawnCount(), more);
}

TEST_F(LooksPanelTest, PointingPreviewsLeavingRestoresAndAClickIsOneStep) {
  open("phantom:head:24");
  const QImage plain = fullPicture(*window_);
  const scene::Scene before = window_->document()->scene();
  QListWidgetItem* const normal = itemNamed(panel_->lookList(), "Normal");
  ASSERT_NE(normal, nullptr);
  std::optional<scene::Scene> previewed;
  QObject::connect(panel_, &ui::LooksPanel::previewed, [&](const auto& scene) { previewed = scene; });
  pointTo(normal);
  ASSERT_TRUE(waitUntil([&] { return previewed.has_value(); }));
  EXPECT_EQ(previewed->look.mode, scene::LookMode::normal);
  EXPECT_GT(differingPixels(plain, fullPicture(*window_)), 0.05);
  EXPECT_EQ(window_->document()->scene(), before) << "nothing is edited";
  EXPECT_FALSE(window_->document()->history().canUndo());
  QEvent leave(QEvent::Leave);
  QCoreApplication::sendEvent(panel_->lookList()->viewport(), &leave);
  EXPECT_FALSE(previewed.has_value());
  EXPECT_EQ(differingPixels(plain, fullPicture(*window_)), 0.0);

  QTest::mouseClick(panel_->lookList()->viewport(), Qt::LeftButton, Qt::NoModifier, centreOfItem(normal));
  EXPECT_EQ(window_->document()->scene().look.mode, scene::LookMode::normal);
  window_->document()->undo();
  EXPECT_EQ(window_->document()->scene(), before);
  EXPECT_FALSE(window_->document()->history().canUndo());
}

TEST_F(LooksPanelTest, TheShiftMovesTheValuesOfThePresetThatIsShown) {
  open("phantom:head:24");
  EXPECT_FALSE(panel_->findChild<QSlider*>()->isEnabled());
  QTest::mouseClick(panel_->presetList()->viewport(), Qt::LeftButton, Qt::NoModifier,
                    centreOfItem(itemNamed(panel_->presetList(), "CT skin over bone")));
  ASSERT_TRUE(waitUntil([this] { return panel_->findChild<QSlider*>()->isEnabled(); }));
  EXPECT_EQ(window_->document()->scene().surfaces.front().value, -200.0);
  panel_->findChild<QSlider*>()->setFocus();
  QTest::keyClick(panel_->findChild<QSlider*>(), Qt::Key_Right);
  const double step = 500.0 / panel_->findChild<QSlider*>()->maximum();
  EXPECT_EQ(window_->document()->scene().surfaces.front().value, -200.0 + step);
  EXPECT_EQ(window_->document()->scene().surfaces.at(1).value, 300.0 + step);
  EXPECT_EQ(window_->document()->history().undoName(), "Shift preset CT skin over bone");
  ASSERT_TRUE(waitUntil([this] { return panel_->findChild<QSlider*>()->value() == 1; }));
  // Something else was changed: it is no preset any more.
  ui::Edit edit{window_->document()->scene(), "Change albedo", {}, false};
  edit.scene.surfaces.front().albedo = {0.2, 0.5, 0.9};
  window_->document()->edit(edit);
  EXPECT_TRUE(waitUntil([this] { return !panel_->findChild<QSlider*>()->isEnabled(); }));
}

// MR skin is CT skin but for isovalue and needs.
TEST_F(LooksPanelTest, APresetThatWasChosenIsNotShifted) {
  // A head without a unit, as of an MR scanner.
  const QString file = newFile("head.nrrd");
  {
    std::ofstream out(file.toStdString(), std::ios::binary);
    out << "NRRD0004\ntype: uint8\nencoding: raw\ndimension: 3\nsizes: 24 24 24\n"
        << "space: left-posterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n\n";
    for (int z = 0; z < 24; ++z)
      for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 24; ++x)
          out.put(static_cast<char>(std::max(0.0, 240.0 - 20.0 * std::hypot(x - 11.5, y - 11.5, z - 11.5))));
  }
  open(file);
  int chosen = 0;
  for (int i = 0; i < panel_->presetList()->count(); ++i) {
    QListWidgetItem* const item = panel_->presetList()->item(i);
    if (!(item->flags() & Qt::ItemIsEnabled)) continue;
    ++chosen;
    SCOPED_TRACE(item->text().toStdString());
    QTest::mouseClick(panel_->presetList()->viewport(), Qt::LeftButton, Qt::NoModifier, centreOfItem(item));
    const QString tip = "Shifts the isovalues of " + item->text();
    EXPECT_TRUE(waitUntil([&] { return panel_->findChild<QSlider*>()->toolTip() == tip; }, 5000))
        << panel_->findChild<QSlider*>()->toolTip().toStdString();
    EXPECT_EQ(panel_->findChild<QSlider*>()->value(), 0);
  }
  EXPECT_GE(chosen, 2);
}

// What is drawn here is dropped when the window draws.
TEST_F(LooksPanelTest, TheWindowsPictureComesFirst) {
  ui::ThumbnailPainter painter;
  ASSERT_TRUE(load(*window_, "phantom:head:64"));
  const ui::VolumePointer volume = window_->document()->volume();
  painter.setVolume(volume);
  painter.want({window_->document()->resolvedScene()}, {128, 128});
  painter.setBusy(true);
  fullPicture(*window_);
  EXPECT_EQ(painter.drawnCount(), 0) << "while the window draws nothing is begun";
  painter.setBusy(false);
  ASSERT_TRUE(waitUntil([&] { return painter.complete(); }));
  EXPECT_EQ(painter.drawnCount(), 1);
}

}  // namespace isolux::test
