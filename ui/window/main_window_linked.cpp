// Several windows of ui/window/main_window.h: new ones, and views that go together.
#include <QAction>
#include <QApplication>
#include <QSignalBlocker>

#include "app/files/state_folder.h"
#include "app/view_math/linked_camera.h"
#include "ui/document/document_keeper.h"
#include "ui/window/main_window.h"

namespace isolux::ui {

namespace {

std::vector<MainWindow*> otherWindows(const MainWindow* self) {
  std::vector<MainWindow*> others;
  for (QWidget* widget : QApplication::topLevelWidgets())
    if (auto* window = qobject_cast<MainWindow*>(widget); window && window != self && window->isVisible())
      others.push_back(window);
  return others;
}

}  // namespace

MainWindow* MainWindow::newWindow() {
  auto* const window = new MainWindow;
  window->setAttribute(Qt::WA_DeleteOnClose);
  connect(qApp, &QGuiApplication::commitDataRequest, window, &MainWindow::commitData, Qt::DirectConnection);
  window->move(pos() + QPoint(32, 32));
  window->show();
  const QSignalBlocker quiet(window->link_);  // it shows nothing yet that others could follow
  window->link_->setChecked(link_->isChecked());
  if (const auto folder = app::stateFolder(); keeper_ && !folder.empty())
    window->keepDocument(folder / "autosave");
  return window;
}

void MainWindow::useViewElsewhere() {
  for (MainWindow* other : otherWindows(this)) other->takeCamera(*this);
}

// As one step of undo, however long the other view turns. Does nothing without a volume on either side.
void MainWindow::takeCamera(const MainWindow& other) {
  const VolumePointer &theirs = other.document_->volume(), &ours = document_->volume();
  if (!theirs || !ours || document_->loading()) return;
  const scene::Camera camera = app::linkedCamera(other.document_->camera(), theirs->facts, ours->facts);
  if (camera == document_->scene().camera) return;
  Edit edit{document_->scene(), tr("Follow linked view"), "linked camera", true};
  edit.scene.camera = camera;
  follows_ = true;  // what follows from this is no request of this window
  document_->edit(edit);
  follows_ = false;
}

// After each change of the scene.
void MainWindow::tellLinked() {
  const scene::Camera camera = document_->camera();
  if (camera == toldCamera_) return;
  toldCamera_ = camera;
  // A volume that was just opened does not turn the others by its first view.
  if (follows_ || awaitsFirstPicture_ || !link_->isChecked() || !document_->volume()) return;
  for (MainWindow* other : otherWindows(this))
    if (other->link_->isChecked()) other->takeCamera(*this);
}

// One check links all windows, and the others show what this one sees; a check taken back takes its window
// out.
void MainWindow::setLinked(bool linked) {
  if (!linked) return;
  for (MainWindow* other : otherWindows(this)) {
    const QSignalBlocker quiet(other->link_);
    other->link_->setChecked(true);
    other->takeCamera(*this);
  }
}

}  // namespace isolux::ui
