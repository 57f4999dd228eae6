// Cuts by hand in the window: handles dragged by the mouse, the menu, the rows of planes; one undo step each.
#include <cmath>

#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QMenuBar>
#include <QPainter>
#include <QSettings>
#include <QTest>
#include <QToolButton>

#include <glm/geometric.hpp>

#include "tests/support/ui/window_fixture.h"
#include "ui/editors/planes_widget.h"
#include "ui/editors/setting_editor.h"
#include "ui/panels/settings_panel.h"
#include "ui/viewport/cut_menu.h"
#include "ui/viewport/overlay_painters.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/number_spin_box.h"
#include "ui/window/message_bar.h"

namespace isolux::test {
namespace {

using app::CutGrip;
using app::CutPart;

class CutsTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    ASSERT_TRUE(load(*window_, "phantom:ball:48"));
    edit([](scene::Scene& scene) {
      scene.camera.projection = scene::Projection::orthographic;
      scene.camera.frames = scene::Frames::volume;  // from the front
    });
  }
  void TearDown() override {
    QSettings().remove("cuts/handles");
    WindowTest::TearDown();
  }
  ui::Viewport* viewport() { return window_->viewport(); }
  const scene::Clip& clip() { return window_->document()->scene().clip; }
  std::size_t steps() { return window_->document()->history().position(); }
  std::string lastStep() { return window_->document()->history().undoName(); }
  template <class Change>
  void edit(const Change& change) {
    ui::Edit edit{window_->document()->scene(), "Test", {}, false};
    change(edit.scene);
    window_->document()->edit(edit);
  }
  QAction* menuAction(const QString& menu, const QString& text) {
    for (QAction* top : window_->menuBar()->actions())
      if (top->text().remove('&') == "Cut")
        for (QAction* action : menu.isEmpty() ? top->menu()->actions() : actionsOf(top->menu(), menu))
          if (action->text().remove('&') == text) return action;
    return nullptr;
  }
  static QList<QAction*> actionsOf(QMenu* menu, const QString& name) {
    for (QAction* action : menu->actions())
      if (action->menu() && action->text().remove('&') == name) return action->menu()->actions();
    return {};
  }
  QPoint knob(const CutGrip& grip) {
    for (const app::CutShape& shape : viewport()->cutShapes())
      for (const app::CutKnob& one : shape.knobs)
        if (one.grip == grip) return {static_cast<int>(one.pixel.x), static_cast<int>(one.pixel.y)};
    ADD_FAILURE() << "no such handle";
    return {};
  }
  app::TurnedBox turnedBoxAt(int number) { return app::turnedBox(clip(), number); }
  void cutAcross() {
    edit([](scene::Scene& scene) { scene.clip.planes = {{{0, 0, 0}, {1, 0, 0}}}; });
  }
};

TEST_F(CutsTest, HandlesAreThereWhereSomethingIsCut) {
  EXPECT_TRUE(viewport()->cutShapes().empty());
  cutAcross();
  ASSERT_EQ(viewport()->cutShapes().size(), 1u);
  QAction* const handles = menuAction({}, "Show handles");
  handles->trigger();
  EXPECT_TRUE(viewport()->cutShapes().empty());
  EXPECT_FALSE(QSettings().value("cuts/handles").toBool());  // kept for the next window
  handles->trigger();
  EXPECT_EQ(viewport()->cutShapes().size(), 1u);
  viewport()->setTool(scene::MarkKind::point);  // clicks are meant for the surface
  EXPECT_TRUE(viewport()->cutShapes().empty());
  viewport()->setTool(std::nullopt);
  EXPECT_EQ(viewport()->cutShapes().size(), 1u);
}

TEST_F(CutsTest, ADragMovesThePlaneAndIsOneStep) {
  cutAcross();
  const std::size_t before = steps();
  const QPoint from = knob({1, CutPart::move, 0}), to = from + QPoint(30, 4);
  const double mmPerPixel = app::projectedOn(app::cutStageOf(window_->document()->resolvedScene(),
                                                             window_->document()->volume()->grid().geometry(),
                                                             {viewport()->width(), viewport()->height()}),
                                             {0, 0, 0})
                                .mmPerPixel;
  const auto camera = window_->document()->scene().camera;
  drag(viewport(), from, to);
  EXPECT_NEAR(std::abs(clip().planes[0].point.x), 30.0 * mmPerPixel, 1e-6);  // seen from the front
  EXPECT_EQ(clip().planes[0].normal, glm::dvec3(1, 0, 0));
  EXPECT_EQ(window_->document()->scene().camera, camera);
  EXPECT_EQ(steps(), before + 1);
  EXPECT_EQ(lastStep(), "Move plane 1");
  EXPECT_LE((knob({1, CutPart::move, 0}) - (from + QPoint(30, 0))).manhattanLength(),
            2);  // under the pointer
  window_->document()->undo();
  EXPECT_EQ(clip().planes[0].point.x, 0.0);
  EXPECT_TRUE(viewport()->complete() || waitUntil([&] { return viewport()->complete(); }));
}

TEST_F(CutsTest, WhileItIsDraggedPicturesAreDraftsAndAtRestTheFullOneFollows) {
  cutAcross();
  fullPicture(*window_);
  const QPoint from = knob({1, CutPart::turn, 0});
  QTest::mousePress(viewport(), Qt::LeftButton, {}, from);
  QTest::mouseMove(viewport(), from + QPoint(-20, -20));
  EXPECT_EQ(viewport()->cursor().shape(), Qt::ClosedHandCursor);
  EXPECT_NE(clip().planes[0].normal, glm::dvec3(1, 0, 0));
  EXPECT_FALSE(viewport()->complete());
  QTest::mouseRelease(viewport(), Qt::LeftButton, {}, from + QPoint(-20, -20));
  EXPECT_EQ(lastStep(), "Turn plane 1");
  EXPECT_TRUE(waitUntil([&] { return viewport()->complete(); }));
}

TEST_F(CutsTest, EscPutsTheCutBackAndLeavesNoStep) {
  cutAcross();
  const scene::Clip before = clip();
  const std::size_t count = steps();
  const QPoint from = knob({1, CutPart::move, 0});
  QTest::mousePress(viewport(), Qt::LeftButton, {}, from);
  QTest::mouseMove(viewport(), from + QPoint(25, 0));
  EXPECT_FALSE(clip() == before);
  QTest::keyClick(viewport(), Qt::Key_Escape);
  EXPECT_TRUE(clip() == before);
  EXPECT_EQ(steps(), count);
  QTest::mouseMove(viewport(), from + QPoint(40, 0));  // the drag is over
  QTest::mouseRelease(viewport(), Qt::LeftButton, {}, from + QPoint(40, 0));
  EXPECT_TRUE(clip() == before);
  EXPECT_EQ(steps(), count);
}

TEST_F(CutsTest, TheHandleUnderThePointerIsMarked) {
  cutAcross();
  QTest::mouseMove(viewport(), knob({1, CutPart::turn, 0}));
  EXPECT_EQ(viewport()->cursor().shape(), Qt::OpenHandCursor);
  EXPECT_TRUE(viewport()->toolTip().contains("Plane 1"));
  QTest::mouseMove(viewport(), QPoint(4, viewport()->height() / 2));
  EXPECT_TRUE(viewport()->toolTip().isEmpty());
  // Seen on black and on white.
  for (const QColor& ground : {QColor(Qt::black), QColor(Qt::white)}) {
    QImage plain(viewport()->size(), QImage::Format_RGB32);
    plain.fill(ground);
    QImage rest = plain, marked = plain;
    QPainter first(&rest), second(&marked);
    ui::paintCuts(first, viewport()->cutShapes(), std::nullopt);
    ui::paintCuts(second, viewport()->cutShapes(), CutGrip{1, CutPart::turn, 0});
    first.end();
    second.end();
    EXPECT_GT(differingPixels(rest, plain, 100), 0.002);
    EXPECT_GT(differingPixels(marked, rest, 60), 0.0005);
  }
}

TEST_F(CutsTest, AFaceOfTheBoxIsDraggedAloneAndTheWheelStepsByVoxels) {
  menuAction({}, "Box")->trigger();
  EXPECT_EQ(lastStep(), "Box");
  ASSERT_EQ(clip().box.size(), 2u);
  EXPECT_FALSE(menuAction({}, "Box")->isEnabled());
  const auto before = clip().box;
  const CutGrip right{0, CutPart::face, 1};
  drag(viewport(), knob(right), knob(right) + QPoint(20, 0));
  EXPECT_EQ(lastStep(), "Move a face of the box");
  EXPECT_NEAR(clip().box[0].x, before[0].x, 1e-9);
  EXPECT_GT(std::abs(clip().box[1].x - before[1].x), 1.0);
  EXPECT_NEAR(clip().box[1].y, before[1].y, 1e-9);
  cutAcross();
  const std::size_t count = steps();
  wheel(viewport(), knob({1, CutPart::move, 0}), 1);
  wheel(viewport(), knob({1, CutPart::move, 0}), 1);
  EXPECT_EQ(steps(), count + 1);
  const double spacing =
      glm::length(glm::dvec3(window_->document()->volume()->grid().geometry().worldFromVoxel[0]));
  EXPECT_NEAR(std::abs(clip().planes[0].point.x), 2.0 * spacing, 1e-9);
}

TEST_F(CutsTest, TheMenuAddsPlanesThatShowTheirFace) {
  ASSERT_TRUE(menuAction({}, "Plane across Z"));  // phantoms state no anatomy
  menuAction({}, "Plane across Z")->trigger();
  EXPECT_EQ(lastStep(), "Plane across Z");
  edit([](scene::Scene& scene) { scene.slice.position = {3, 2, 1}; });
  menuAction({}, "Plane across X")->trigger();
  viewport()->setFocus();
  QTest::keyClick(viewport(), Qt::Key_C);
  ASSERT_EQ(clip().planes.size(), 3u);
  const glm::dvec3 back = scene::frameOf(window_->document()->resolvedScene().camera).back;
  for (const scene::ClipPlane& plane : clip().planes) EXPECT_GE(glm::dot(plane.normal, back), 0.0);
  EXPECT_EQ(std::abs(clip().planes[0].normal.z), 1.0);
  EXPECT_EQ(clip().planes[1].point, glm::dvec3(3, 2, 1));
  EXPECT_LT(glm::distance(clip().planes[2].normal, back), 1e-12);
  QTest::keyClick(viewport(), Qt::Key_C, Qt::ShiftModifier);  // flips the last
  EXPECT_LT(glm::distance(clip().planes[2].normal, -back), 1e-12);
  menuAction("Plane 3", "Align to the nearest axis")->trigger();
  EXPECT_NEAR(glm::length(glm::round(clip().planes[2].normal) - clip().planes[2].normal), 0.0, 1e-12);
  menuAction("Plane 3", "Turn to the viewer")->trigger();
  EXPECT_LT(glm::distance(clip().planes[2].normal, back), 1e-12);
  menuAction("Plane 1", "Remove")->trigger();
  ASSERT_EQ(clip().planes.size(), 2u);
  EXPECT_EQ(clip().planes[0].point, glm::dvec3(3, 2, 1));
  menuAction("Cut faces", "Whole slice")->trigger();
  EXPECT_EQ(clip().cap, scene::ClipCap::whole);
  menuAction("Cut surfaces", "Isosurface 1")->trigger();
  EXPECT_FALSE(window_->document()->scene().surfaces.front().clipped);
  menuAction({}, "Remove all cuts")->trigger();
  EXPECT_TRUE(clip().planes.empty());
  EXPECT_EQ(clip().cap, scene::ClipCap::whole);  // how cuts look is no cut
}

// The octant toward the viewer; its faces are dragged, it is removed from its own menu, and with all cuts.
TEST_F(CutsTest, ACornerIsCutAwayDraggedAndRemoved) {
  EXPECT_FALSE(menuAction({}, "Corner 1")->isVisible());
  menuAction({}, "Cut a corner away")->trigger();
  ASSERT_EQ(clip().removed.size(), 2u);
  EXPECT_EQ(lastStep(), "Cut a corner away");
  const auto before = clip().removed;
  const glm::dvec3 back = scene::frameOf(window_->document()->resolvedScene().camera).back;
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_GE((before[1][axis] - before[0][axis]) * back[axis], 0.0) << axis;
  edit([](scene::Scene& scene) { scene.camera.eye = glm::dvec3(90, -300, 110); });
  ASSERT_EQ(viewport()->cutShapes().size(), 1u);
  const CutGrip face{-1, CutPart::face, before[1].x > before[0].x ? 0 : 1};  // the inner one across x
  drag(viewport(), knob(face), knob(face) + QPoint(15, 0));
  EXPECT_EQ(lastStep(), "Move a face of the box");
  EXPECT_NE(turnedBoxAt(-1).middle.x, 0.5 * (before[0].x + before[1].x));
  EXPECT_NEAR(turnedBoxAt(-1).middle.y, 0.5 * (before[0].y + before[1].y), 1e-9);
  QTest::mouseClick(viewport(), Qt::RightButton, {}, knob({-1, CutPart::move, 0}));
  auto* const menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
  ASSERT_TRUE(menu);
  EXPECT_EQ(menu->title().remove('&'), "Corner 1");
  menu->close();
  menuAction({}, "Cut a corner away")->trigger();
  menuAction("Corner 1", "Remove")->trigger();
  EXPECT_EQ(lastStep(), "Remove corner 1");
  ASSERT_EQ(clip().removed.size(), 2u);
  EXPECT_TRUE(menuAction({}, "Cut faces")->isEnabled());
  menuAction({}, "Remove all cuts")->trigger();
  EXPECT_TRUE(clip().removed.empty());
  edit([](scene::Scene& scene) { scene.clip.removed.assign(2 * scene::kRemovedBoxes, glm::dvec3(0.0)); });
  EXPECT_FALSE(menuAction({}, "Cut a corner away")->isEnabled());
}

TEST_F(CutsTest, WhatCannotActSaysWhy) {
  const auto says = [&](const char* text, const char* why) {
    QAction* const action = menuAction({}, text);
    EXPECT_FALSE(action->isEnabled()) << text;
    EXPECT_TRUE(action->toolTip().contains(why)) << action->toolTip().toStdString();
  };
  says("Remove all cuts", "Nothing is cut");
  says("Reverse last plane", "no plane");
  says("Plane through three points", "Set three points");
  edit([](scene::Scene& scene) { scene.clip.planes.assign(6, {{0, 0, 0}, {0, 0, 1}}); });
  says("Plane across Z", "remove one");
  EXPECT_TRUE(menuAction({}, "Remove all cuts")->isEnabled());
  EXPECT_FALSE(menuAction({}, "Remove all cuts")->toolTip().contains("Nothing is cut:"));
}

TEST_F(CutsTest, APlaneGoesThroughThreeMarkedPoints) {
  edit([](scene::Scene& scene) {
    scene.marks = {{scene::MarkKind::point, "A", {{1, 2, 3}}},
                   {scene::MarkKind::distance, "B", {{9, -2, 4}, {-5, 0, 7}}}};
  });
  menuAction({}, "Plane through three points")->trigger();
  ASSERT_EQ(clip().planes.size(), 1u);
  for (const glm::dvec3& p : {glm::dvec3(1, 2, 3), glm::dvec3(9, -2, 4), glm::dvec3(-5, 0, 7)})
    EXPECT_NEAR(glm::dot(clip().planes[0].normal, p - clip().planes[0].point), 0.0, 1e-9);
  edit([](scene::Scene& scene) {
    scene.marks = {{scene::MarkKind::circle, "C", {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}}};
  });
  menuAction({}, "Plane through three points")->trigger();
  EXPECT_EQ(clip().planes.size(), 1u);
  EXPECT_TRUE(window_->messageBar()->text().contains("collinear"));
}

TEST_F(CutsTest, ARightClickOnAHandleOpensThatPlanesMenu) {
  cutAcross();
  QTest::mouseClick(viewport(), Qt::RightButton, {}, knob({1, CutPart::move, 0}));
  auto* const menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
  ASSERT_TRUE(menu);
  EXPECT_EQ(menu->title().remove('&'), "Plane 1");
  menu->close();
}

// Rows of numbers: added, typed, flipped, removed; a normal without length is refused and the old one comes
// back.
TEST_F(CutsTest, PlanesAreRowsOfNumbers) {
  auto* const panel = window_->panel<ui::SettingsPanel>();
  ui::SettingEditor* const editor = panel->editor("clip.planes");
  auto* const planes = qobject_cast<ui::PlanesWidget*>(editor->valueWidget());
  ASSERT_TRUE(planes);
  EXPECT_TRUE(editor->isWide());
  planes->addButton()->click();
  ASSERT_EQ(clip().planes.size(), 1u);
  EXPECT_EQ(clip().planes[0], (scene::ClipPlane{{0, 0, 0}, {0, 0, 1}}));
  const auto type = [](ui::NumberSpinBox* box, double value) { box->setValue(value); };
  type(planes->rows()[0].numbers[0], 4.5);
  type(planes->rows()[0].numbers[3], -0.25);
  EXPECT_EQ(clip().planes[0], (scene::ClipPlane{{4.5, 0, 0}, {-0.25, 0, 1}}));
  planes->rows()[0].flip->click();
  EXPECT_EQ(clip().planes[0].normal, glm::dvec3(0.25, 0, -1));
  planes->addButton()->click();
  ASSERT_EQ(planes->rows().size(), 2u);
  EXPECT_EQ(clip().planes[1], clip().planes[0]);
  type(planes->rows()[1].numbers[3], 0.0);
  type(planes->rows()[1].numbers[5], 0.0);  // no direction is left
  EXPECT_EQ(clip().planes[1].normal, glm::dvec3(0, 0, -1));
  EXPECT_EQ(planes->rows()[1].numbers[5]->value(), -1.0);
  planes->rows()[0].remove->click();
  ASSERT_EQ(clip().planes.size(), 1u);
  EXPECT_EQ(planes->rows().size(), 1u);
  for (int i = 0; i < 5; ++i) planes->addButton()->click();
  EXPECT_EQ(clip().planes.size(), 6u);
  EXPECT_FALSE(planes->addButton()->isEnabled());
  window_->document()->undo();
  EXPECT_EQ(planes->rows().size(), 5u);
}

}  // namespace
}  // namespace isolux::test
