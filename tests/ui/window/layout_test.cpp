// Layouts with one key, docks that move, and what of both is remembered between starts.
#include <QAction>
#include <QDockWidget>
#include <QScreen>
#include <QSettings>
#include <QTest>

#include "tests/support/ui/window_fixture.h"
#include "ui/slices/slice_board.h"
#include "ui/viewport/viewport.h"
#include "ui/window/message_bar.h"
#include "ui/window/window_layout.h"

namespace isolux::test {
namespace {

using ui::ViewLayout;
using volume::SliceDirection;

class LayoutTest : public WindowTest {
 protected:
  // Closes the window, and opens another, as the next start does.
  void startAgain() {
    window_->close();
    window_.reset();
    window_ = makeWindow();
  }
  QDockWidget* dock(const char* name) { return window_->findChild<QDockWidget*>(name); }
};

TEST(ScreenFit, WhatFitsStaysAndTheRestIsMoved) {
  using ui::fittedOnScreens;
  const QRect left(0, 0, 1000, 800), right(1000, 0, 2000, 1200);
  EXPECT_EQ(fittedOnScreens({100, 100, 500, 400}, {left, right}), QRect(100, 100, 500, 400));
  EXPECT_EQ(fittedOnScreens({900, 100, 500, 400}, {left, right}), QRect(1000, 100, 500, 400));
  EXPECT_EQ(fittedOnScreens({5000, -900, 500, 400}, {left}), QRect(500, 0, 500, 400));
  EXPECT_EQ(fittedOnScreens({-50, 700, 5000, 4000}, {left}), left);
  EXPECT_EQ(fittedOnScreens({5, 6, 7, 8}, {}), QRect(5, 6, 7, 8));
}

TEST_F(LayoutTest, OneKeyGoesThroughTheLayouts) {
  ASSERT_TRUE(load(*window_, "phantom:ball:24"));
  ui::SliceBoard* const board = window_->slices();
  for (const ViewLayout expected : {ViewLayout::fourUp, ViewLayout::slices, ViewLayout::picture}) {
    QTest::keyClick(window_.get(), Qt::Key_F4);
    EXPECT_EQ(board->arrangement(), expected);
    EXPECT_EQ(window_->viewport()->isVisible(), expected != ViewLayout::slices);
    EXPECT_EQ(board->view(SliceDirection::axial)->isVisible(), expected != ViewLayout::picture);
  }
}

TEST_F(LayoutTest, SlicesAloneAreDrawnAndMessagesAreSeen) {
  window_->slices()->arrange(ui::ViewLayout::slices);
  ASSERT_TRUE(load(*window_, "phantom:ball:24"));
  EXPECT_TRUE(waitUntil([&] {
    for (const auto d : {SliceDirection::axial, SliceDirection::coronal, SliceDirection::sagittal})
      if (!window_->slices()->view(d)->complete() || window_->slices()->view(d)->shown().isNull())
        return false;
    return true;
  }));
  const ui::SliceView* const axial = window_->slices()->view(SliceDirection::axial);
  EXPECT_GT(axial->height(), 3 * window_->slices()->view(SliceDirection::coronal)->height() / 2);
  window_->messageBar()->show(ui::MessageBar::Kind::error, "broken");
  EXPECT_TRUE(window_->messageBar()->isVisible());
}

TEST_F(LayoutTest, IsRememberedBetweenStarts) {
  window_->slices()->arrange(ui::ViewLayout::fourUp);
  window_->resize(870, 610);
  window_->addDockWidget(Qt::LeftDockWidgetArea, dock("Volume"));
  dock("Passes")->close();
  dock("Marks")->setFloating(true);
  ASSERT_TRUE(waitUntil([&] { return window_->dockWidgetArea(dock("Volume")) == Qt::LeftDockWidgetArea; }));
  startAgain();
  EXPECT_EQ(window_->slices()->arrangement(), ViewLayout::fourUp);
  EXPECT_EQ(window_->dockWidgetArea(dock("Volume")), Qt::LeftDockWidgetArea);
  EXPECT_TRUE(dock("Passes")->isHidden());
  EXPECT_TRUE(dock("Marks")->isFloating());
  EXPECT_FALSE(dock("Settings")->isFloating());
}

TEST_F(LayoutTest, FromFullScreenThePanelsAreRemembered) {
  window_->slices()->arrange(ui::ViewLayout::slices);
  QTest::keyClick(window_.get(), Qt::Key_F11);
  ASSERT_TRUE(waitUntil([&] { return window_->isFullScreen(); }));
  EXPECT_TRUE(dock("Settings")->isHidden());
  startAgain();
  EXPECT_FALSE(dock("Settings")->isHidden());
  EXPECT_EQ(window_->slices()->arrangement(), ViewLayout::slices);
}

TEST_F(LayoutTest, AStoredStateThatFitsNoMoreIsMended) {
  const QRect screen = window_->screen()->availableGeometry();
  dock("Marks")->setFloating(true);
  dock("Marks")->move(screen.right() + 3000, screen.bottom() + 2000);
  startAgain();
  EXPECT_TRUE(dock("Marks")->isFloating());
  EXPECT_TRUE(screen.intersects(dock("Marks")->frameGeometry()));
  window_->close();
  QSettings().setValue("window/state", QByteArray("no state"));
  QSettings().setValue("window/geometry", QByteArray("nor geometry"));
  QSettings().setValue("window/layout", "hexagonal");
  window_ = makeWindow();
  EXPECT_EQ(window_->slices()->arrangement(), ViewLayout::picture);
  EXPECT_FALSE(dock("Settings")->isHidden());
  EXPECT_FALSE(dock("Marks")->isFloating());
}

// Among tabs the tab is the title; alone or floating the dock has one to move it by.
TEST_F(LayoutTest, ADockHasATitleWhereNoTabNamesIt) {
  EXPECT_TRUE(waitUntil([&] { return dock("Volume")->titleBarWidget() != nullptr; }));
  dock("Volume")->setFloating(true);
  EXPECT_TRUE(waitUntil([&] { return dock("Volume")->titleBarWidget() == nullptr; }));
  dock("Volume")->setFloating(false);
  EXPECT_TRUE(waitUntil([&] { return dock("Volume")->titleBarWidget() != nullptr; }));
  window_->addDockWidget(Qt::LeftDockWidgetArea, dock("Volume"));
  EXPECT_TRUE(waitUntil([&] { return dock("Volume")->titleBarWidget() == nullptr; }));
}

}  // namespace
}  // namespace isolux::test
