// The panel of looks and presets of ui/window/main_window.h: what it previews is shown, and nothing is
// edited.
#include "scene/rules/automatic.h"
#include "ui/presets/looks_panel.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"

namespace isolux::ui {

void MainWindow::connectLooks() {
  auto* const looks = panel<LooksPanel>();
  connect(looks, &LooksPanel::previewed, this, &MainWindow::preview);
  connect(viewport_, &Viewport::drawing, looks, &LooksPanel::setDrawing);
}

void MainWindow::preview(const std::optional<scene::Scene>& scene) {
  const VolumePointer& volume = document_->volume();
  if (scene && volume)
    viewport_->setScene(*scene, scene::resolve(*scene, volume->facts));
  else
    viewport_->setScene(document_->scene(), document_->resolvedScene());
}

}  // namespace isolux::ui
