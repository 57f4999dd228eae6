// Full screen and the Tab key of ui/window/main_window.h: the picture with the menu and the isovalue, and
// everything as it was afterwards.
#include <QApplication>
#include <QShortcut>
#include <QStatusBar>
#include <QWindowStateChangeEvent>

#include "ui/window/main_window.h"
#include "ui/window/window_layout.h"

namespace isolux::ui {

void MainWindow::toggleFullScreen(bool on) {
  leaveFullScreen_->setEnabled(on);
  if (on) {
    layout_->hideAllBut();
    setWindowState(windowState() | Qt::WindowFullScreen);
  } else {
    setWindowState(windowState() & ~Qt::WindowFullScreen);  // maximised again, where it was
    layout_->showAgain();
  }
  statusBar()->setVisible(!on);
}

// Panels behind others are no stops of the Tab key: Qt lays them out of sight and counts them as visible.
bool MainWindow::focusNextPrevChild(bool next) {
  constexpr int mostStops = 1000;
  for (int i = 0; i < mostStops; ++i) {
    if (!QMainWindow::focusNextPrevChild(next)) return false;
    const QWidget* const focused = QApplication::focusWidget();
    if (focused == nullptr || !layout_->isBehind(focused)) return true;
  }
  return true;
}

// The window manager may end full screen as well.
void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() != QEvent::WindowStateChange || isFullScreen()) return;
  if (static_cast<QWindowStateChangeEvent*>(event)->oldState() & Qt::WindowFullScreen)
    fullScreen_->setChecked(false);
}

}  // namespace isolux::ui
