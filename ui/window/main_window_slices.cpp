// Slices beside the picture, of ui/window/main_window.h: a point that is clicked on in one is shown in the
// others.
#include "app/cuts/cut_edits.h"
#include "app/slices/slice_choice.h"
#include "app/slices/slice_content.h"
#include "ui/panels/marks_panel.h"
#include "ui/slices/slice_board.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"
#include "ui/window/message_bar.h"

namespace isolux::ui {

void MainWindow::connectSlices() {
  connect(slices_, &SliceBoard::edited, this, &MainWindow::applyEdit);
  connect(slices_, &SliceBoard::gestureEnded, this, &MainWindow::endGesture);
  connect(slices_, &SliceBoard::failed, message_, &MessageBar::showError);
  connect(slices_, &SliceBoard::planesChanged, this, &MainWindow::showSlicesInPicture);
  connect(viewport_, &Viewport::clicked, this,
          [this](const app::Pick& pick) { moveCrosshair(pick.worldMm); });
  connect(panel<MarksPanel>(), &MarksPanel::chosen, this, &MainWindow::moveCrosshair);
}

// Only where slices are shown: else a click would change the scene and show nothing of it.
void MainWindow::moveCrosshair(glm::dvec3 worldMm) {
  const VolumePointer& volume = document_->volume();
  if (!volume || !slices_->slicesShown()) return;
  if (app::slicePosition(document_->scene(), volume->grid().geometry()) == worldMm) return;
  Edit edit{document_->scene(), tr("Move crosshair")};
  edit.scene.slice.position = worldMm;
  applyEdit(edit);
}

void MainWindow::showSlicesInPicture() {
  SlicesInPicture shown;
  const VolumePointer& volume = document_->volume();
  if (volume) {
    const volume::GridGeometry& geometry = volume->grid().geometry();
    shown.crosshairMm = app::slicePosition(document_->resolvedScene(), geometry);
    for (const PlaneOfView& view : slices_->planes())
      shown.outlines.push_back(
          {app::outlineOf({view.plane.pointMm, view.plane.normal()}, geometry.corners()), view.color});
  }
  viewport_->setSlices(std::move(shown));
}

}  // namespace isolux::ui
