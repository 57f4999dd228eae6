// Full screen of ui/window/main_window.h: the picture with the menu and the isovalue, and everything as it
// was afterwards.
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

// The window manager may end full screen as well.
void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() != QEvent::WindowStateChange || isFullScreen()) return;
  if (static_cast<QWindowStateChangeEvent*>(event)->oldState() & Qt::WindowFullScreen)
    fullScreen_->setChecked(false);
}

}  // namespace isolux::ui
