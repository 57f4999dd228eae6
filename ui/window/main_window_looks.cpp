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
  previewing_ = scene && volume;
  if (previewing_)
    viewport_->setScene(*scene, scene::resolve(*scene, volume->facts));
  else
    viewport_->setScene(document_->scene(), document_->resolvedScene());
}

// A preview may be turned, but is not what is edited.
void MainWindow::applyViewEdit(const Edit& edit) {
  if (!previewing_) {
    applyEdit(edit);
    return;
  }
  Edit view{document_->scene(), edit.name, edit.mergeKey, edit.endsAfterPause};
  view.scene.camera = edit.scene.camera;
  applyEdit(view);
}

}  // namespace isolux::ui
