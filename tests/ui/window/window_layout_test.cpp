// Sizes and places of what the window is made of: messages, full screen, small screens, long names.
#include "tests/support/ui/window_fixture.h"

#include <filesystem>
#include <fstream>

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QStatusBar>
#include <QTabBar>
#include <QTest>
#include <QToolBar>
#include <QToolButton>

#include "ui/editors/elided_label.h"
#include "ui/panels/light_status.h"
#include "ui/panels/volume_panel.h"
#include "ui/viewport/viewport.h"
#include "ui/window/message_bar.h"

namespace isolux::test {
namespace {

using Kind = ui::MessageBar::Kind;

QDockWidget* dock(ui::MainWindow& window, const char* name) {
  return window.findChild<QDockWidget*>(name);
}

QPushButton* buttonOf(ui::MainWindow& window, const QString& label) {
  for (QPushButton* button : window.messageBar()->buttons())
    if (button->text() == label && button->isVisible()) return button;
  return nullptr;
}

TEST_F(WindowTest, AMessageNeitherResizesThePictureNorRunsAPassAgain) {
  ASSERT_TRUE(load(*window_, "phantom:ball:32"));
  fullPicture(*window_);
  window_->messageBar()->clear();
  const QSize size = window_->viewport()->size();
  int ran = 0;
  QObject::connect(window_->viewport(), &ui::Viewport::reported, [&](const render::FrameReport& report) {
    for (const render::PassReport& pass : report.passes) ran += pass.state == render::PassState::ran;
  });
  const QString file(170, 'n');
  window_->messageBar()->show(Kind::error, "/data/" + file + ".mhd: DimSize: an axis has 0 voxels");
  EXPECT_TRUE(waitUntil([&] { return window_->messageBar()->isVisible(); }));
  fullPicture(*window_);  // drawn again: what has changed is computed
  EXPECT_EQ(window_->messageBar()->width(), size.width());
  EXPECT_EQ(window_->viewport()->size(), size);
  window_->messageBar()->clear();
  EXPECT_TRUE(waitUntil([&] { return !window_->messageBar()->isVisible(); }));
  fullPicture(*window_);
  EXPECT_EQ(window_->viewport()->size(), size);
  EXPECT_EQ(ran, 0);
}

TEST_F(WindowTest, EveryTabShowsItsWholeName) {
  window_->resize(1280, 800);
  const auto tabs = [&] {
    for (QTabBar* bar : window_->findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
      if (bar->isVisible()) return bar;
    return static_cast<QTabBar*>(nullptr);
  };
  ASSERT_TRUE(waitUntil([&] { return tabs() != nullptr; }));
  const int before = tabs()->count();
  EXPECT_GE(tabs()->width(), tabs()->sizeHint().width());
  window_->showPanel("Accuracy");
  ASSERT_TRUE(waitUntil([&] { return tabs()->count() == before + 1; }));
  EXPECT_TRUE(waitUntil([&] { return tabs()->width() >= tabs()->sizeHint().width(); }))
      << tabs()->width() << " of " << tabs()->sizeHint().width();
}

TEST_F(WindowTest, AQuestionWaitsForItsAnswerBehindNotesAndErrors) {
  ui::MessageBar& bar = *window_->messageBar();
  int restored = 0, discarded = 0;
  const auto ask = [&] {
    bar.show(Kind::question, "Restore the head?",
             {{"Restore", [&] { ++restored; }}, {"Discard", [&] { ++discarded; }}});
  };
  ask();
  EXPECT_EQ(bar.text(), "Restore the head?");
  bar.show(Kind::error, "broken");
  EXPECT_EQ(bar.text(), "broken");
  EXPECT_EQ(buttonOf(*window_, "Restore"), nullptr);
  bar.clear();
  EXPECT_EQ(bar.text(), "Restore the head?");
  bar.clear();  // another file is opened: no answer
  EXPECT_TRUE(bar.isVisible());
  ASSERT_NE(buttonOf(*window_, "Restore"), nullptr);
  buttonOf(*window_, "Restore")->click();
  EXPECT_EQ(restored, 1);
  EXPECT_TRUE(bar.isHidden());
  ask();
  bar.findChild<QToolButton*>()->click();  // the cross
  EXPECT_TRUE(bar.isHidden());
  EXPECT_EQ(restored + discarded, 1);
}

// Data that nobody measured: no note of eight seconds.
TEST_F(WindowTest, AWarningStaysUntilItIsClosed) {
  ui::MessageBar& bar = *window_->messageBar();
  bar.show(Kind::warning, "slices are missing");
  bar.show(Kind::note, "Saved");
  EXPECT_EQ(bar.text(), "Saved");
  bar.clear();  // as after eight seconds
  EXPECT_EQ(bar.text(), "slices are missing");
  bar.clear();
  EXPECT_TRUE(bar.isVisible());
  bar.findChild<QToolButton*>()->click();  // the cross
  EXPECT_TRUE(bar.isHidden());
  bar.show(Kind::warning, "slices are missing");
  bar.withdraw(Kind::warning);  // another volume
  EXPECT_TRUE(bar.isHidden());
}

TEST_F(WindowTest, AMessageOfAnyLengthLetsTheWindowBeNarrow) {
  const int before = window_->minimumSizeHint().width();
  window_->messageBar()->show(Kind::error, QString(400, 'w'));
  EXPECT_EQ(window_->minimumSizeHint().width(), before);
  EXPECT_LE(window_->messageBar()->minimumSizeHint().width(), 200);
  EXPECT_GT(window_->messageBar()->height(), 2 * window_->fontMetrics().lineSpacing()) << "it wraps";
}

TEST_F(WindowTest, FullScreenAndBackLeavesPanelsTabsAndSizeAsTheyWere) {
  QAction* fullScreen = nullptr;
  for (QAction* action : window_->findChildren<QAction*>())
    if (action->shortcut() == QKeySequence("F11")) fullScreen = action;
  ASSERT_NE(fullScreen, nullptr);
  const auto inFront = [&](const char* name) { return !dock(*window_, name)->visibleRegion().isEmpty(); };
  dock(*window_, "Passes")->close();
  window_->showPanel("volume");
  window_->setWindowState(Qt::WindowMaximized);
  ASSERT_TRUE(waitUntil([&] { return inFront("Volume"); }));
  fullScreen->trigger();
  EXPECT_TRUE(waitUntil([&] { return window_->isFullScreen(); }));
  EXPECT_TRUE(dock(*window_, "Volume")->isHidden());
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  EXPECT_TRUE(waitUntil([&] { return !window_->isFullScreen(); }));
  EXPECT_FALSE(fullScreen->isChecked());
  EXPECT_TRUE(window_->isMaximized());
  EXPECT_TRUE(dock(*window_, "Passes")->isHidden());
  EXPECT_FALSE(dock(*window_, "Settings")->isHidden());
  EXPECT_TRUE(waitUntil([&] { return inFront("Volume"); }));
  EXPECT_FALSE(inFront("Settings"));
  QTest::keyClick(window_.get(), Qt::Key_Escape);  // ends nothing else
  EXPECT_TRUE(window_->isMaximized());
}

TEST_F(WindowTest, ALongNameWidensNothing) {
  const QString ball = writeBall(16);
  const QString file = newFile(QString(170, 'n') + ".mhd");
  const int before = window_->minimumSizeHint().width();
  std::ifstream header(ball.toStdString());
  std::ofstream(file.toStdString()) << header.rdbuf();
  std::filesystem::copy(ball.chopped(3).toStdString() + "raw",
                        std::filesystem::path(file.toStdString()).parent_path() / "ball.raw");
  ASSERT_TRUE(load(*window_, file));
  window_->showPanel("volume");
  const auto* area = window_->panel<ui::VolumePanel>()->findChild<QScrollArea*>();
  EXPECT_TRUE(waitUntil([&] {  // shown and laid out
    return area->widget()->isVisible() && area->widget()->width() == area->viewport()->width();
  }));
  EXPECT_EQ(window_->minimumSizeHint().width(), before);
  EXPECT_LE(area->widget()->minimumSizeHint().width(), area->viewport()->width());
  for (QMenu* menu : window_->findChildren<QMenu*>()) {
    if (!menu->title().contains("re&cent")) continue;
    Q_EMIT menu->aboutToShow();
    EXPECT_LT(menu->sizeHint().width(), 600);
    EXPECT_GT(menu->actions().size(), 1);
  }
}

TEST_F(WindowTest, ADragWhoseReleaseWentElsewhereEndsWithTheNextMove) {
  ASSERT_TRUE(load(*window_, "phantom:ball:24"));
  ui::Viewport* viewport = window_->viewport();
  const QPoint centre = viewport->rect().center();
  const auto move = [&](QPoint to, Qt::MouseButtons buttons) {
    QMouseEvent event(QEvent::MouseMove, QPointF(to), viewport->mapToGlobal(QPointF(to)), Qt::NoButton,
                      buttons, Qt::NoModifier);
    QCoreApplication::sendEvent(viewport, &event);
  };
  QTest::mousePress(viewport, Qt::LeftButton, Qt::NoModifier, centre);
  move(centre + QPoint(20, 0), Qt::LeftButton);
  const scene::Camera turned = window_->document()->scene().camera;
  EXPECT_TRUE(turned.eye.has_value());
  move(centre + QPoint(60, 0), Qt::NoButton);  // a menu of the desktop took the release
  EXPECT_EQ(window_->document()->scene().camera, turned);
  move(centre + QPoint(90, 0), Qt::NoButton);
  EXPECT_EQ(window_->document()->scene().camera, turned);
}

// Buttons go whole, the view's letters first; recording stays.
TEST_F(WindowTest, TheToolBarHasNoHalfButtons) {
  auto* const bar = window_->findChild<QToolBar*>("Tools");
  const auto shown = [&] {
    QStringList names;
    for (QAction* action : bar->actions())
      if (const QWidget* widget = bar->widgetForAction(action);
          widget && widget->isVisible() && !action->isSeparator()) {
        names += action->text().isEmpty() ? widget->accessibleName() : action->text();
        EXPECT_GE(widget->width(), widget->sizeHint().width()) << names.back().toStdString();
        EXPECT_TRUE(bar->rect().contains(widget->geometry())) << names.back().toStdString();
      }
    return names;
  };
  const auto widths = [&](int width) {
    window_->resize(width, 640);
    EXPECT_TRUE(waitUntil([&] { return bar->width() == width; }));
    QCoreApplication::sendPostedEvents();
    QCoreApplication::processEvents();
    return shown();
  };
  const QStringList all = widths(1280);
  const auto has = [](const QStringList& names, const QString& text) {
    return !names.filter(text).isEmpty();
  };
  EXPECT_TRUE(has(all, "Left") && has(all, "recording") && has(all, "Presets"));
  for (const int width : {860, 800, 740, 700}) {
    SCOPED_TRACE(width);
    if (width < window_->minimumSizeHint().width()) continue;
    const QStringList fewer = widths(width);
    EXPECT_FALSE(has(fewer, "Left") && fewer.size() < all.size());
    EXPECT_TRUE(has(fewer, "recording") && has(fewer, "Presets") && has(fewer, "Look"));
  }
  EXPECT_EQ(widths(1280), all);
}

// Of a text that has no room whole parts are left out.
TEST_F(WindowTest, TheStatusBarCutsNoWordOrNumber) {
  window_->resize(800, 640);
  ASSERT_TRUE(load(*window_, "phantom:head:24"));
  app::LightState state;
  state.phase = app::LightState::Phase::baking;
  state.counters.samplesWanted = 100;
  state.counters.samplesDone = 50;
  state.counters.raysPerSecond = 264000.0;
  state.counters.secondsLeft = 18.0;
  window_->panel<ui::LightStatus>()->setState(state, false);
  auto* const accuracy = window_->findChild<QLabel*>("pictureAccuracy");
  accuracy->setText("Depth ± 1.4 mm (noise, discretisation) · rounding ± 0.53 µm · normal ± 0.012°");
  accuracy->show();
  app::Pick pick{};
  Q_EMIT window_->viewport()->pointed(pick);
  ASSERT_TRUE(waitUntil([&] { return window_->panel<ui::LightStatus>()->width() > 150; }, 5000))
      << window_->panel<ui::LightStatus>()->width() << ' ' << window_->panel<ui::LightStatus>()->isVisible();
  int labels = 0;
  for (const QLabel* label : window_->statusBar()->findChildren<QLabel*>()) {
    if (!label->isVisible() || label->text().isEmpty() || label->pixmap().width() > 0) continue;
    ++labels;
    const auto* const elided = qobject_cast<const ui::ElidedLabel*>(label);
    if (!elided) {
      EXPECT_GE(label->width(), label->sizeHint().width()) << label->text().toStdString();
      continue;
    }
    QString text = elided->shownText();
    EXPECT_LE(label->fontMetrics().horizontalAdvance(text), std::max(0, label->contentsRect().width()));
    if (!text.endsWith("…")) continue;
    text = text.chopped(1).trimmed();
    EXPECT_TRUE(label->text().startsWith(text) && (text.isEmpty() || label->text()[text.size()] == ' '))
        << text.toStdString();
  }
  EXPECT_GE(labels, 3);
  for (const auto* label : window_->panel<ui::LightStatus>()->findChildren<ui::ElidedLabel*>())
    EXPECT_TRUE(label->shownText().startsWith("Light: 50 %")) << label->shownText().toStdString();
}

TEST_F(WindowTest, TheFirstSizeFitsTheScreen) {
  EXPECT_EQ(ui::firstWindowSize({2560, 1440}), QSize(1280, 800));
  for (const QSize screen : {QSize(1280, 720), QSize(1280, 800), QSize(1024, 600)}) {
    const QSize size = ui::firstWindowSize(screen);
    EXPECT_LT(size.width(), screen.width());
    EXPECT_LT(size.height(), screen.height() - 20) << "room for a title bar";
  }
  const ui::MainWindow fresh;
  EXPECT_EQ(fresh.size(), ui::firstWindowSize(fresh.screen()->availableSize()));
  EXPECT_LE(fresh.minimumSizeHint().width(), 800);
  EXPECT_LE(fresh.minimumSizeHint().height(), 560);
}

}  // namespace
}  // namespace isolux::test
