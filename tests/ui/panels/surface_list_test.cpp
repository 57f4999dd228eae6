// The list of isosurfaces, and their handles on the histogram, by the widgets themselves.
#include "ui/panels/surface_list.h"
#include "tests/support/surfaces.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QContextMenuEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include "tests/support/ui/window_fixture.h"
#include "ui/editors/histogram_slider.h"
#include "ui/panels/isovalue_panel.h"
#include "ui/slices/slice_board.h"
#include "ui/slices/slice_view.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/number_spin_box.h"

namespace isolux::test {

namespace {

// Of another scene than the document's, for a moment.
QImage pictureWith(const scene::Scene& scene, ui::MainWindow& window,
                   const std::function<QImage()>& picture) {
  const scene::Scene before = window.document()->scene();
  window.document()->edit({scene, "only for a picture", {}, false});
  QImage image = picture();
  window.document()->undo();
  EXPECT_EQ(window.document()->scene(), before);
  return image;
}

}  // namespace

// A CT from the start: to bone by hand, then one click adds the skin around it.
TEST_F(WindowTest, SkinOverBoneIsTwoGestures) {
  ASSERT_TRUE(load(*window_, "phantom:head:48"));
  ui::IsovaluePanel* const panel = window_->panel<ui::IsovaluePanel>();
  EXPECT_TRUE(panel->findChild<ui::NumberSpinBox*>()->isVisible());
  const auto place = [&](double value) {
    return panel->findChild<ui::HistogramSlider*>()->positionOf(value).toPoint();
  };
  const scene::Scene start = window_->document()->scene();
  QTest::mouseClick(panel->findChild<ui::HistogramSlider*>(), Qt::LeftButton, Qt::NoModifier, place(300.0));
  QTest::mouseClick(panel->addButton(), Qt::LeftButton);
  const scene::Scene both = window_->document()->scene();
  ASSERT_TRUE(both.surfaces.at(1).shown);
  EXPECT_EQ(both.surfaces.at(1).value, -300.0);
  EXPECT_EQ(window_->document()->history().undoName(), "Add isosurface");

  // Both are seen: the picture is neither that of the skin alone nor that of the bone alone.
  const auto picture = [&] { return fullPicture(*window_); };
  const QImage shown = picture();
  scene::Scene boneOnly = both, skinOnly = both;
  test::surfaceAt(boneOnly, 1).shown = false;
  skinOnly.surfaces.front().opacity = 0.0;
  EXPECT_GT(differingPixels(shown, pictureWith(boneOnly, *window_, picture), 12), 0.02);
  EXPECT_GT(differingPixels(shown, pictureWith(skinOnly, *window_, picture), 12), 0.02);

  // Two steps of undo are all that was done.
  window_->document()->undo();
  window_->document()->undo();
  EXPECT_EQ(window_->document()->scene(), start);
  EXPECT_FALSE(window_->document()->history().canUndo());
}

// More rows than have room are scrolled, not squeezed into one another.
TEST_F(WindowTest, RowsOfManyIsosurfacesDoNotOverlap) {
  ASSERT_TRUE(load(*window_, "phantom:head:32"));
  scene::Scene scene = window_->document()->scene();
  for (std::size_t i = 1; i < 10; ++i) test::surfaceAt(scene, i).value = 100.0 * static_cast<double>(i);
  window_->document()->edit({scene, "Add isosurfaces"});
  const auto* const list = window_->panel<ui::IsovaluePanel>()->findChild<ui::SurfaceList*>();
  ASSERT_EQ(list->rows().size(), 10u);
  QCoreApplication::processEvents();  // the layout follows
  for (std::size_t i = 1; i < 10; ++i)
    EXPECT_GE(list->rows()[i].value->geometry().top(), list->rows()[i - 1].value->geometry().bottom());
}

TEST_F(WindowTest, ALongListIsSearchedAndItsRowsAreMoved) {
  ASSERT_TRUE(load(*window_, "phantom:head:32"));
  scene::Scene scene = window_->document()->scene();
  for (std::size_t i = 0; i < 14; ++i) {
    test::surfaceAt(scene, i).value = 100.0 * static_cast<double>(i);
    test::surfaceAt(scene, i).name = "Layer " + std::to_string(i);
  }
  window_->document()->edit({scene, "Add isosurfaces"});
  auto* const list = window_->panel<ui::IsovaluePanel>()->findChild<ui::SurfaceList*>();
  ASSERT_EQ(list->rows().size(), 14u);
  QCoreApplication::processEvents();  // the layout follows
  const auto names = [&] {
    std::string all;
    for (const scene::Surface& surface : window_->document()->scene().surfaces)
      all += surface.name.substr(6) + ' ';
    return all;
  };
  QTest::keyClick(list->rows()[1].handle, Qt::Key_Down);
  EXPECT_TRUE(names().starts_with("0 2 1 3 ")) << names();
  drag(list->rows()[4].handle, list->rows()[4].handle->rect().center(),
       list->rows()[4].handle->mapFrom(list, list->rows()[2].handle->geometry().center()));
  EXPECT_TRUE(names().starts_with("0 2 4 1 3 5 ")) << names();
  EXPECT_EQ(window_->document()->history().undoName(), "Move surface");
  window_->document()->undo();
  window_->document()->undo();
  EXPECT_TRUE(names().starts_with("0 1 2 3 ")) << names();

  ASSERT_TRUE(list->searchLine()->isVisible());
  list->searchLine()->setText("layer 12");
  for (std::size_t i = 0; i < 14; ++i) EXPECT_EQ(list->rows()[i].name->isVisible(), i == 12) << i;
  list->searchLine()->clear();
  EXPECT_TRUE(list->rows()[0].name->isVisible());
}

TEST_F(WindowTest, EveryIsosurfaceHasAHandleAndARow) {
  ASSERT_TRUE(load(*window_, "phantom:head:32"));
  ui::IsovaluePanel* const panel = window_->panel<ui::IsovaluePanel>();
  ui::HistogramSlider* const slider = panel->findChild<ui::HistogramSlider*>();
  const auto scene = [&] { return window_->document()->scene(); };
  const auto at = [&](double value) { return slider->positionOf(value).toPoint(); };
  QTest::mouseClick(slider, Qt::LeftButton, Qt::AltModifier, at(600.0));
  ASSERT_EQ(panel->findChild<ui::SurfaceList*>()->rows().size(), 2u);
  EXPECT_TRUE(panel->findChild<ui::SurfaceList*>()->isVisible() &&
              !panel->findChild<ui::NumberSpinBox*>()->isVisible());
  const double pixel = slider->plot().shownRange() / slider->width();
  EXPECT_NEAR(*scene().surfaces.at(1).value, 600.0, pixel);
  EXPECT_FALSE(scene().surfaces.front().value.has_value()) << "the first stays automatic";

  // Its handle is dragged, and keys go on with it.
  drag(slider, slider->linePosition(1).toPoint(), at(900.0));
  EXPECT_NEAR(*scene().surfaces.at(1).value, 900.0, pixel);
  EXPECT_EQ(slider->active(), 1);
  const double before = *scene().surfaces.at(1).value;
  QTest::keyClick(slider, Qt::Key_Right);
  EXPECT_GT(*scene().surfaces.at(1).value, before);
  EXPECT_FALSE(scene().surfaces.front().value.has_value());
  drag(slider, slider->linePosition(0).toPoint(), at(-100.0));
  EXPECT_EQ(slider->active(), 0);
  EXPECT_NEAR(*scene().surfaces.front().value, -100.0, pixel);
  EXPECT_GT(*scene().surfaces.at(1).value, before);

  // By the menu of a right click: a third.
  QContextMenuEvent ask(QContextMenuEvent::Mouse, at(200.0), slider->mapToGlobal(at(200.0)));
  QApplication::sendEvent(slider, &ask);
  auto* const menu = slider->findChild<QMenu*>();
  ASSERT_NE(menu, nullptr);
  EXPECT_TRUE(menu->actions().front()->text().startsWith("Add isosurface at 2"));
  menu->actions().front()->trigger();
  menu->close();
  EXPECT_NEAR(*scene().surfaces.at(2).value, 200.0, pixel);
  EXPECT_EQ(panel->findChild<ui::SurfaceList*>()->rows().size(), 3u);
}

TEST_F(WindowTest, RowsOfTheListEditTheirIsosurface) {
  ASSERT_TRUE(load(*window_, "phantom:head:32"));
  ui::IsovaluePanel* const panel = window_->panel<ui::IsovaluePanel>();
  const auto scene = [&] { return window_->document()->scene(); };
  QTest::mouseClick(panel->addButton(), Qt::LeftButton);
  ASSERT_EQ(panel->findChild<ui::SurfaceList*>()->rows().size(), 2u);
  const auto row = [&](std::size_t i) { return panel->findChild<ui::SurfaceList*>()->rows()[i]; };

  row(1).name->setFocus();
  row(1).name->selectAll();
  QTest::keyClicks(row(1).name, "Skull");
  QTest::keyClick(row(1).name, Qt::Key_Return);
  EXPECT_EQ(scene().surfaces.at(1).name, "Skull");
  EXPECT_EQ(window_->document()->history().undoName(), "Rename isosurface");

  row(1).value->setFocus();
  row(1).value->selectAll();
  QTest::keyClicks(row(1).value, "412.5");
  QTest::keyClick(row(1).value, Qt::Key_Return);
  EXPECT_EQ(scene().surfaces.at(1).value, 412.5);

  row(1).opacity->setFocus();
  QTest::keyClick(row(1).opacity, Qt::Key_Left);
  EXPECT_NEAR(scene().surfaces.at(1).opacity, 0.99, 1e-12);
  EXPECT_LT(scene().surfaces.at(1).facingOpacity, 1.0) << "it was added outside";
  QTest::mouseClick(row(1).seeThrough, Qt::LeftButton);
  EXPECT_EQ(scene().surfaces.at(1).facingOpacity, 1.0);

  row(1).shown->click();
  EXPECT_FALSE(scene().surfaces.at(1).shown);
  ASSERT_EQ(panel->findChild<ui::SurfaceList*>()->rows().size(), 2u) << "what is hidden stays in the list";
  row(1).shown->click();
  EXPECT_TRUE(scene().surfaces.at(1).shown);

  QTest::mouseClick(row(0).remove, Qt::LeftButton);
  EXPECT_EQ(scene().surfaces.front().value, 412.5);
  EXPECT_EQ(scene().surfaces.front().name, "Skull");
  EXPECT_FALSE(panel->findChild<ui::SurfaceList*>()->isVisible());
  EXPECT_TRUE(panel->findChild<ui::NumberSpinBox*>()->isVisible());
  window_->document()->undo();
  EXPECT_EQ(panel->findChild<ui::SurfaceList*>()->rows().size(), 2u);
}

TEST_F(WindowTest, ARightClickInASliceAddsTheIsosurfaceOfTheValueThere) {
  ASSERT_TRUE(load(*window_, "phantom:head:32"));
  window_->slices()->arrange(ui::ViewLayout::fourUp);
  auto* const view = window_->slices()->findChild<ui::SliceView*>();
  ASSERT_NE(view, nullptr);
  ASSERT_TRUE(waitUntil([&] { return view->isVisible() && view->complete(); }));
  QTest::mouseClick(view, Qt::RightButton, Qt::NoModifier, view->rect().center());
  auto* const menu = view->findChild<QMenu*>();
  ASSERT_NE(menu, nullptr);
  QAction* const add = menu->actions().front();
  ASSERT_TRUE(add->text().startsWith("Add isosurface at this value")) << add->text().toStdString();
  add->trigger();
  menu->close();
  const scene::Surface& added = window_->document()->scene().surfaces.at(1);
  EXPECT_TRUE(added.shown);
  EXPECT_GT(added.value.value(), window_->document()->volume()->facts.minimum);
}

}  // namespace isolux::test
