// The panels of ui/window/main_window.h that draw pictures of their own, of looks and of what accuracy costs:
// what is previewed is shown, and nothing is edited.
#include "scene/rules/automatic.h"
#include "ui/accuracy/accuracy_panel.h"
#include "ui/presets/looks_panel.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"

namespace isolux::ui {

void MainWindow::connectLooks() {
  auto* const looks = panel<LooksPanel>();
  connect(looks, &LooksPanel::previewed, this, &MainWindow::preview);
  connect(viewport_, &Viewport::drawing, looks, &LooksPanel::setDrawing);
  connect(viewport_, &Viewport::drawing, panel<AccuracyPanel>(), &AccuracyPanel::setDrawing);
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
