// Full screen of ui/window/main_window.h: the picture with the menu and the isovalue, and everything as it
// was afterwards.
#include <QDockWidget>
#include <QShortcut>
#include <QStatusBar>
#include <QToolBar>
#include <QWindowStateChangeEvent>

#include "ui/window/main_window.h"

namespace isolux::ui {

void MainWindow::toggleFullScreen(bool on) {
  leaveFullScreen_->setEnabled(on);
  if (on) {
    layoutBefore_ = saveState();
    for (QToolBar* bar : findChildren<QToolBar*>()) bar->hide();
    for (const Docked& docked : panels_) docked.dock->hide();
    setWindowState(windowState() | Qt::WindowFullScreen);
  } else {
    setWindowState(windowState() & ~Qt::WindowFullScreen);  // maximised again, where it was
    restoreState(layoutBefore_);                            // which docks were open, and which lay in front
  }
  statusBar()->setVisible(!on);
}

// The window manager may end full screen as well.
void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() != QEvent::WindowStateChange || isFullScreen()) return;
  if (static_cast<QWindowStateChangeEvent*>(event)->oldState() & Qt::WindowFullScreen)
    fullScreen_->setChecked(false);
}

}  // namespace isolux::ui
