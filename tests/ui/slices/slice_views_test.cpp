// Slices beside the picture: what they show, and what the mouse does in them.
#include <cmath>
#include <fstream>

#include <QAction>
#include <QDialogButtonBox>
#include <QMenu>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>

#include <glm/geometric.hpp>

#include "tests/support/ui/window_fixture.h"
#include "ui/panels/marks_panel.h"
#include "ui/slices/oblique_dialog.h"
#include "ui/slices/slice_board.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/number_spin_box.h"

namespace isolux::test {
namespace {

using ui::SliceView;
using volume::SliceDirection;

class SliceViewsTest : public WindowTest {
 protected:
  SliceView* view(SliceDirection direction) { return window_->slices()->view(direction); }
  bool loadFourUp(const QString& path) {
    if (!load(*window_, path)) return false;
    window_->slices()->arrange(ui::ViewLayout::fourUp);
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
  QTest::keyClick(window_.get(), Qt::Key_F4);  // the slices alone
  QTest::keyClick(window_.get(), Qt::Key_F4);
  EXPECT_TRUE(waitUntil([&] { return window_->viewport()->size() == alone; }));
  EXPECT_FALSE(view(SliceDirection::sagittal)->isVisible());
}

// It has no surface, but something to see.
TEST_F(SliceViewsTest, AVolumeOfOneSliceIsShownAsSlices) {
  const QString file = newFile("slice.mha");
  std::ofstream stream(file.toStdString(), std::ios::binary);
  stream
      << "ObjectType = Image\nNDims = 3\nDimSize = 8 8 1\nElementSpacing = 1 1 1\nElementType = MET_UCHAR\n"
         "ElementDataFile = LOCAL\n";
  for (char i = 0; i < 64; ++i) stream.put(i);
  stream.close();
  ASSERT_TRUE(load(*window_, "phantom:ball:16"));
  EXPECT_FALSE(window_->slices()->slicesShown());
  ASSERT_TRUE(load(*window_, file));
  EXPECT_TRUE(window_->slices()->arrangement() == ui::ViewLayout::fourUp);
  EXPECT_TRUE(complete());
}

// The ball's circle stands about the crosshair, in the surface's colour.
TEST_F(SliceViewsTest, ShowTheSurfacesCurve) {
  ASSERT_TRUE(loadFourUp("phantom:ball:32"));
  ui::Edit edit{scene(), "Colour", {}, false};
  edit.scene.surfaces.front().albedo = {1.0, 0.0, 0.0};
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
  const auto [low, high] = window_->document()->volume()->grid().geometry().worldBounds();
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

TEST_F(SliceViewsTest, PanMovesThePictureWithThePointerAndNoUndoStep) {
  ASSERT_TRUE(loadFourUp("phantom:head:32"));
  SliceView* const axial = view(SliceDirection::axial);
  const std::size_t done = steps();
  const QPoint from = axial->rect().center(), to = from + QPoint(30, -20);
  const auto under = [&](QPoint place) {
    return axial->plane()->at(glm::dvec2(place.x(), place.y()) * axial->devicePixelRatioF() - 0.5);
  };
  const glm::dvec3 held = under(from);
  drag(axial, from, to, Qt::MiddleButton);
  EXPECT_LT(glm::distance(under(to), held), 1e-6);
  drag(axial, to, from, Qt::LeftButton, Qt::ShiftModifier);
  EXPECT_LT(glm::distance(under(from), held), 1e-6);
  EXPECT_EQ(steps(), done);
  drag(axial, from, from + QPoint(20000, 0), Qt::MiddleButton, {}, 3);
  const auto [low, high] = window_->document()->volume()->grid().geometry().worldBounds();
  EXPECT_GE(under(from).x, low.x - 2.0 * axial->plane()->pixelMm()) << "the volume stays in sight";
  EXPECT_TRUE(complete());
}

// The three lie on the right of it, in the surface; where nothing shows slices a click changes nothing.
TEST_F(SliceViewsTest, AClickOnTheSurfaceMovesTheCrosshairThere) {
  ASSERT_TRUE(load(*window_, "phantom:ball:32"));
  fullPicture(*window_);
  const std::size_t done = steps();
  QTest::mouseClick(window_->viewport(), Qt::LeftButton, {}, window_->viewport()->rect().center());
  EXPECT_EQ(steps(), done);
  window_->slices()->arrange(ui::ViewLayout::fourUp);
  ASSERT_TRUE(complete());
  fullPicture(*window_);
  QTest::mouseClick(window_->viewport(), Qt::LeftButton, {}, window_->viewport()->rect().center());
  EXPECT_EQ(steps(), done + 1);
  ASSERT_TRUE(scene().slice.position);
  EXPECT_NEAR(glm::length(*scene().slice.position), 0.35 * 31.0, 0.05);
  drag(window_->viewport(), {40, 40}, {90, 60});
  EXPECT_EQ(steps(), done + 2) << "turned, and no more";
}

TEST_F(SliceViewsTest, AMarkMovesTheCrosshairWhenItIsSetAndWhenItIsChosen) {
  ASSERT_TRUE(loadFourUp("phantom:ball:32"));
  fullPicture(*window_);
  const std::size_t done = steps();
  window_->viewport()->setTool(scene::MarkKind::point);
  QTest::mouseClick(window_->viewport(), Qt::LeftButton, {}, window_->viewport()->rect().center());
  window_->viewport()->setTool(std::nullopt);
  EXPECT_EQ(steps(), done + 1) << "pin and crosshair are one step";
  ASSERT_EQ(scene().marks.size(), 1u);
  const glm::dvec3 pin = scene().marks[0].points[0];
  EXPECT_EQ(scene().slice.position, pin);
  SliceView* const axial = view(SliceDirection::axial);
  drag(axial, axial->rect().center(), axial->rect().center() + QPoint(20, 10));
  EXPECT_NE(scene().slice.position, pin);
  window_->showPanel("Marks");
  QTreeWidget* const list = window_->panel<ui::MarksPanel>()->findChild<QTreeWidget*>();
  ASSERT_TRUE(waitUntil([&] { return list->isVisible() && list->topLevelItemCount() == 1; }));
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                    list->visualItemRect(list->topLevelItem(0)).center());
  EXPECT_EQ(scene().slice.position, pin);
}

TEST_F(SliceViewsTest, TheOthersPlanesAreDrawnInTheirColoursHereAndInThePicture) {
  ASSERT_TRUE(loadFourUp("phantom:ball:32"));
  fullPicture(*window_);
  const QColor coronal = view(SliceDirection::coronal)->planeOfView()->color;
  const auto isNear = [](const QColor& a, const QColor& b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()) < 45;
  };
  const auto count = [&](const QImage& image, const QColor& color) {
    int found = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) found += isNear(image.pixelColor(x, y), color);
    return found;
  };
  SliceView* const axial = view(SliceDirection::axial);
  EXPECT_GT(count(axial->grab().toImage(), coronal), axial->width() / 2) << "a line across";
  EXPECT_GT(count(window_->viewport()->grab().toImage(), coronal), 50);
  window_->slices()->arrange(ui::ViewLayout::picture);
  fullPicture(*window_);
  EXPECT_EQ(count(window_->viewport()->grab().toImage(), coronal), 0);
}

class SliceMenuTest : public SliceViewsTest {
 protected:
  // As a right click opens it.
  QMenu* menuOf(SliceView* view) {
    QTest::mouseClick(view, Qt::RightButton, {}, view->rect().center());
    QMenu* menu = nullptr;
    for (QMenu* found : view->findChildren<QMenu*>("slice"))
      if (found->isVisible()) menu = found;
    return menu;
  }
  static QAction* entry(QMenu* menu, const QString& text) {
    for (QAction* action : menu->findChildren<QAction*>())
      if (action->text() == text && !action->isSeparator()) return action;
    return nullptr;
  }
  void choose(SliceView* view, const QString& text) {
    QMenu* const menu = menuOf(view);
    ASSERT_NE(menu, nullptr);
    QAction* const action = entry(menu, text);
    ASSERT_NE(action, nullptr) << text.toStdString();
    action->trigger();
    menu->close();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
};

TEST_F(SliceMenuTest, WindowsForTissuesAreThereForHounsfieldUnits) {
  ASSERT_TRUE(loadFourUp("phantom:head:32"));
  ASSERT_EQ(window_->document()->volume()->volume.unit, "HU");
  SliceView* const axial = view(SliceDirection::axial);
  const std::size_t done = steps();
  std::size_t chosen = 0;
  for (const auto& [name, level, width] :
       {std::tuple{"Bone", 500, 2000}, std::tuple{"Soft tissue", 40, 400}, std::tuple{"Brain", 40, 80},
        std::tuple{"Lung", -600, 1500}, std::tuple{"Angiography", 300, 600}}) {
    choose(axial, name);
    EXPECT_EQ(scene().slice.level, level) << name;
    EXPECT_EQ(scene().slice.width, width) << name;
    EXPECT_EQ(steps(), done + ++chosen) << name;
  }
  EXPECT_TRUE(complete());
  choose(axial, "Automatic");
  EXPECT_FALSE(scene().slice.level);
  EXPECT_FALSE(scene().slice.width);
}

TEST_F(SliceMenuTest, NotForOtherValues) {
  ASSERT_TRUE(loadFourUp("phantom:ball:24"));
  QMenu* const menu = menuOf(view(SliceDirection::coronal));
  ASSERT_NE(menu, nullptr);
  EXPECT_NE(entry(menu, "Automatic"), nullptr);
  EXPECT_EQ(entry(menu, "Bone"), nullptr);
  menu->close();
}

TEST_F(SliceMenuTest, SlabContoursAndConventionAreSettingsWithUndo) {
  ASSERT_TRUE(loadFourUp("phantom:head:32"));
  SliceView* const axial = view(SliceDirection::axial);
  choose(axial, "10 mm");
  EXPECT_EQ(scene().slice.slab, 10.0);
  choose(axial, "Maximum (MIP)");
  EXPECT_EQ(scene().slice.slabMode, scene::SlabMode::maximum);
  choose(axial, "Isocontours");
  EXPECT_EQ(scene().slice.contourWidth, 0.0);
  choose(axial, "Isocontours");
  EXPECT_GT(scene().slice.contourWidth, 0.0);
  choose(axial, "Neurological: the patient's left on the left");
  EXPECT_EQ(scene().slice.convention, scene::Convention::neurological);
  window_->document()->undo();
  EXPECT_EQ(scene().slice.convention, scene::Convention::radiological);
}

TEST_F(SliceMenuTest, AViewShowsACutAndItsWheelMovesIt) {
  ASSERT_TRUE(loadFourUp("phantom:head:32"));
  ui::Edit edit{scene(), "Cut", {}, false};
  edit.scene.clip.planes.push_back({{5.0, 0.0, 3.0}, {1.0, 1.0, 0.5}});
  window_->document()->edit(edit);
  SliceView* const axial = view(SliceDirection::axial);
  const std::size_t done = steps();
  choose(axial, "Cut 1");
  EXPECT_EQ(steps(), done) << "what a view shows is no change of the document";
  ASSERT_TRUE(complete());
  const glm::dvec3 normal = glm::normalize(glm::dvec3(1.0, 1.0, 0.5));
  const auto height = [&] {
    return glm::dot(axial->plane()->at({10.0, 20.0}) - glm::dvec3(5.0, 0.0, 3.0), normal);
  };
  EXPECT_NEAR(std::abs(glm::dot(axial->plane()->frame().normal(), normal)), 1.0, 1e-9);
  EXPECT_NEAR(height(), 0.0, 1e-9);
  wheel(axial, axial->rect().center(), 3);
  const double step = volume::voxelAlong(window_->document()->volume()->grid().geometry(), normal);
  EXPECT_NEAR(height(), 3.0 * step, 1e-9);
  EXPECT_NEAR(glm::dot(scene().clip.planes[0].point - glm::dvec3(5.0, 0.0, 3.0), normal), 3.0 * step, 1e-9);
  ui::Edit none{scene(), "No cut", {}, false};
  none.scene.clip.planes.clear();
  window_->document()->edit(none);
  EXPECT_NEAR(axial->plane()->frame().normal().z, 1.0, 1e-12) << "its own direction again";
  EXPECT_TRUE(complete());
}

TEST_F(SliceMenuTest, AnObliquePlaneIsTypedAndFollowsTheCrosshair) {
  ASSERT_TRUE(loadFourUp("phantom:head:32"));
  SliceView* const sagittal = view(SliceDirection::sagittal);
  choose(sagittal, "Oblique…");
  auto* const dialog = window_->findChild<ui::ObliqueDialog*>();
  ASSERT_NE(dialog, nullptr);
  auto* const ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  for (int i = 0; i < 3; ++i) dialog->normalBox(i)->setValue(0.0);
  EXPECT_FALSE(ok->isEnabled()) << "no direction";
  const glm::dvec3 normal(0.0, 3.0, 4.0), point(2.0, 4.0, 6.0);
  for (int i = 0; i < 3; ++i) {
    dialog->normalBox(i)->setValue(normal[i]);
    dialog->pointBox(i)->setValue(point[i]);
  }
  ok->click();
  ASSERT_TRUE(complete());
  EXPECT_EQ(scene().slice.position, point);
  EXPECT_NEAR(std::abs(glm::dot(sagittal->plane()->frame().normal(), normal / 5.0)), 1.0, 1e-12);
  EXPECT_NEAR(glm::dot(sagittal->plane()->originMm - point, normal), 0.0, 1e-9);
  SliceView* const axial = view(SliceDirection::axial);
  drag(axial, axial->rect().center(), axial->rect().center() + QPoint(0, 30));
  EXPECT_NEAR(glm::dot(sagittal->plane()->originMm - *scene().slice.position, normal), 0.0, 1e-9);
}

TEST_F(SliceViewsTest, KeysMoveStepAndZoom) {
  ASSERT_TRUE(loadFourUp(writeBall(24, {1.0, 1.0, 2.5})));
  SliceView* const axial = view(SliceDirection::axial);
  axial->setFocus();
  const glm::dvec3 before = axial->position();
  const double pixel = axial->plane()->pixelMm();
  QTest::keyClick(axial, Qt::Key_Right);
  QTest::keyClick(axial, Qt::Key_Down);
  EXPECT_LT(
      glm::distance(axial->position(), before + axial->plane()->frame().right + axial->plane()->frame().down),
      1e-9);
  QTest::keyClick(axial, Qt::Key_PageUp);
  EXPECT_NEAR(axial->position().z - before.z, 2.5, 1e-9);
  QTest::keyClick(axial, Qt::Key_Plus);
  EXPECT_LT(axial->plane()->pixelMm(), 0.9 * pixel);
  QTest::keyClick(axial, Qt::Key_Home);
  EXPECT_NEAR(axial->plane()->pixelMm(), pixel, 1e-12);
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
