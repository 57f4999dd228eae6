// The window without a mouse: where the focus is, what it is called, and the camera by keys.
#include <algorithm>
#include <set>

#include <QAccessible>
#include <QApplication>
#include <QDockWidget>
#include <QLineEdit>
#include <QScrollArea>
#include <QTest>

#include <glm/geometric.hpp>

#include "scene/camera.h"
#include "tests/support/ui/window_fixture.h"
#include "ui/panels/settings_panel.h"
#include "ui/slices/slice_board.h"
#include "ui/theme/focus_ring.h"
#include "ui/theme/style.h"
#include "ui/viewport/viewport.h"

namespace isolux::test {
namespace {

class KeyboardTest : public WindowTest {
 protected:
  scene::CameraFrame frame() { return scene::frameOf(window_->document()->resolvedScene().camera); }
  void press(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(window_->viewport(), static_cast<Qt::Key>(key), modifiers);
  }
};

double degreesBetween(glm::dvec3 a, glm::dvec3 b) {
  return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)) * 180.0 / 3.141592653589793;
}

TEST_F(KeyboardTest, ArrowsTurnPanRollAndZoomThePicture) {
  ASSERT_TRUE(load(*window_, "phantom:ball:24"));
  window_->viewport()->setFocus();
  const scene::CameraFrame first = frame();
  press(Qt::Key_Right);
  EXPECT_NEAR(degreesBetween(first.back, frame().back), 4.6, 0.41);
  EXPECT_GT(glm::dot(frame().back, first.right), 0.0) << "the camera goes to the right";
  press(Qt::Key_Left);
  EXPECT_LT(glm::distance(frame().eye, first.eye), 1e-6);
  press(Qt::Key_Up);
  EXPECT_NEAR(degreesBetween(first.back, frame().back), 5.0, 1e-5);
  EXPECT_GT(glm::dot(frame().back, first.up), 0.0);
  press(Qt::Key_Down);
  press(Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_LT(glm::distance(first.back, frame().back), 1e-9);
  EXPECT_LT(glm::dot(frame().eye - first.eye, first.right), 0.0) << "the picture goes to the right";
  press(Qt::Key_Left, Qt::ShiftModifier);
  press(Qt::Key_Right, Qt::ControlModifier);
  EXPECT_NEAR(degreesBetween(first.up, frame().up), 5.0, 1e-5);
  press(Qt::Key_Left, Qt::ControlModifier);
  press(Qt::Key_Plus);
  EXPECT_LT(frame().distance, 0.95 * first.distance);
  press(Qt::Key_Minus);
  EXPECT_NEAR(frame().distance, first.distance, 1e-6 * first.distance);
}

TEST_F(KeyboardTest, KeysThatFollowOneAnotherAreOneStep) {
  ASSERT_TRUE(load(*window_, "phantom:ball:24"));
  window_->viewport()->setFocus();
  for (int i = 0; i < 4; ++i) press(Qt::Key_Right);
  ASSERT_TRUE(window_->document()->history().canUndo());
  window_->document()->undo();
  EXPECT_FALSE(window_->document()->history().canUndo());
}

TEST_F(KeyboardTest, NoKeyIsTakenFromATextField) {
  ASSERT_TRUE(load(*window_, "phantom:ball:24"));
  const scene::Scene before = window_->document()->scene();
  QLineEdit* const line = window_->panel<ui::SettingsPanel>()->searchLine();
  line->setFocus();
  QTest::keyClicks(line, "rfolpm123456 +-");
  for (const auto key : {Qt::Key_Left, Qt::Key_Up, Qt::Key_Home}) QTest::keyClick(line, key);
  EXPECT_EQ(line->text(), "rfolpm123456 +-");
  EXPECT_EQ(window_->document()->scene(), before);
  EXPECT_FALSE(window_->viewport()->tool());
}

// From stop to stop until the first comes again: each is ringed, and the ring is seen.
TEST_F(KeyboardTest, EachStopOfTheTabKeyShowsWhereItIs) {
  ASSERT_TRUE(load(*window_, "phantom:ball:24"));
  window_->slices()->arrange(ui::ViewLayout::fourUp);
  auto* const ring = qApp->findChild<ui::FocusRing*>();
  ASSERT_NE(ring, nullptr);
  window_->viewport()->setFocus();
  std::set<const QWidget*> stops;
  for (int i = 0; i < 400; ++i) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    QCoreApplication::processEvents();
    QWidget* const stop = QApplication::focusWidget();
    ASSERT_NE(stop, nullptr);
    if (!stops.insert(stop).second) break;
    const std::string name =
        std::string(stop->metaObject()->className()) + ' ' + stop->objectName().toStdString() + ' ' +
        QAccessible::queryAccessibleInterface(stop)->text(QAccessible::Name).toStdString();
    ASSERT_EQ(ring->target(), stop) << name;
    const QWidget* frame = nullptr;
    ASSERT_TRUE(waitUntil([&] { return (frame = ring->ring()) != nullptr && frame->isVisible(); })) << name;
    const QRect place = frame->geometry();
    const QImage seen = window_->grab(place).toImage();
    const double ratio = seen.devicePixelRatio();
    int accented = 0;
    for (int x = 0; x < place.width(); ++x)
      accented += seen.pixelColor(static_cast<int>(x * ratio), 0) == ui::colours.accent;
    EXPECT_GT(accented, place.width() / 2) << name;
  }
  EXPECT_GT(stops.size(), 20u);
  EXPECT_TRUE(stops.count(window_->viewport()));
  EXPECT_TRUE(stops.count(window_->slices()->view(volume::SliceDirection::coronal)));
}

TEST_F(KeyboardTest, AClickShowsNoRing) {
  auto* const ring = qApp->findChild<ui::FocusRing*>();
  QLineEdit* const line = window_->panel<ui::SettingsPanel>()->searchLine();
  QTest::mouseClick(line, Qt::LeftButton);
  EXPECT_TRUE(line->hasFocus());
  EXPECT_EQ(ring->target(), nullptr);
}

// What has the focus says its name to those who do not see it.
TEST_F(KeyboardTest, WhatTakesTheFocusHasAName) {
  ASSERT_TRUE(load(*window_, "phantom:ball:24"));
  window_->slices()->arrange(ui::ViewLayout::fourUp);
  int count = 0;
  for (QDockWidget* dock : window_->findChildren<QDockWidget*>()) {
    dock->show();
    dock->raise();
    QCoreApplication::processEvents();
    for (QWidget* widget : window_->findChildren<QWidget*>()) {
      if (!(widget->focusPolicy() & Qt::TabFocus) || !widget->isVisible() || widget->focusProxy()) continue;
      ++count;
      QAccessibleInterface* const access = QAccessible::queryAccessibleInterface(widget);
      ASSERT_NE(access, nullptr);
      EXPECT_FALSE(access->text(QAccessible::Name).trimmed().isEmpty())
          << dock->objectName().toStdString() << ": " << widget->metaObject()->className() << ' '
          << widget->objectName().toStdString() << " in " << widget->parentWidget()->metaObject()->className()
          << ' ' << widget->parentWidget()->objectName().toStdString() << ' '
          << widget->toolTip().left(60).toStdString();
    }
  }
  EXPECT_GT(count, 60);
}

TEST_F(KeyboardTest, KeysLeadToThePanelsAndBack) {
  ASSERT_TRUE(load(*window_, "phantom:ball:24"));
  QTest::keyClick(window_.get(), Qt::Key_1, Qt::ControlModifier);
  const auto within = [](const char* name) {
    return [name] {
      for (const QWidget* w = QApplication::focusWidget(); w; w = w->parentWidget())
        if (w->objectName() == name && qobject_cast<const QDockWidget*>(w)) return true;
      return false;
    };
  };
  EXPECT_TRUE(waitUntil(within("Settings")));
  QTest::keyClick(window_.get(), Qt::Key_4, Qt::ControlModifier);
  EXPECT_TRUE(waitUntil(within("Volume")));
  EXPECT_FALSE(window_->findChild<QDockWidget*>("Volume")->visibleRegion().isEmpty());
  QTest::keyClick(window_.get(), Qt::Key_4, Qt::ControlModifier);
  EXPECT_TRUE(window_->viewport()->hasFocus()) << "again: back to the picture";
  std::set<QWidget*> parts;
  for (int i = 0; i < 8; ++i) {
    QTest::keyClick(window_.get(), Qt::Key_F6);
    parts.insert(QApplication::focusWidget());
  }
  EXPECT_GE(parts.size(), 3u) << "picture, isovalue, panel";
}

}  // namespace
}  // namespace isolux::test
