// The panels of ui/window/main_window.h that draw pictures of their own, of looks and of what accuracy costs:
// what is previewed is shown, and nothing is edited.
#include <QDockWidget>
#include <QLabel>
#include <QStatusBar>

#include "scene/rules/automatic.h"
#include "ui/accuracy/accuracy_panel.h"
#include "ui/document/baked_light.h"
#include "ui/editors/elided_label.h"
#include "ui/levels/full_resolution_view.h"
#include "ui/levels/level_marks.h"
#include "ui/presets/looks_panel.h"
#include "ui/theme/style.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"

namespace isolux::ui {

void MainWindow::connectLooks() {
  auto* const looks = panel<LooksPanel>();
  connect(looks, &LooksPanel::previewed, this, &MainWindow::preview);
  connect(viewport_, &Viewport::drawing, looks, &LooksPanel::setDrawing);
  auto* const accuracy = panel<AccuracyPanel>();
  connect(viewport_, &Viewport::drawing, accuracy, &AccuracyPanel::setDrawing);
  const auto tellComplete = [this] { tellAccuracy(); };
  connect(viewport_, &Viewport::drawn, accuracy, tellComplete);
  connect(document_, &Document::sceneChanged, accuracy, tellComplete);
  connect(light_, &BakedLight::lightChanged, accuracy, &AccuracyPanel::setLight);
  for (const Docked& docked : panels_)
    if (docked.panel == accuracy)
      connect(docked.dock, &QDockWidget::visibilityChanged, accuracy, &AccuracyPanel::seenChanged);
  const auto layOver = [this](Viewport::Over what) {
    return [this, what](const QImage& image, const QImage& of, const std::optional<render::Tile>& legend) {
      viewport_->setOver(what, image, of, legend);
    };
  };
  connect(accuracy, &AccuracyPanel::overlayPainted, viewport_, layOver(Viewport::Over::errors));
  connect(levelMarks_, &LevelMarks::painted, viewport_, layOver(Viewport::Over::structure));
  connect(levelMarks_, &LevelMarks::changed, this, &MainWindow::showLevel);
  connect(fullResolution_, &FullResolutionView::painted, viewport_,
          [this](const QImage& image, const QImage& of) {
            viewport_->setOver(Viewport::Over::levelZero, image, of);
          });
  connect(fullResolution_, &FullResolutionView::changed, this, &MainWindow::showLevel);
  connect(fullResolution_, &FullResolutionView::opened, levelMarks_, &LevelMarks::lookAgain);
  auto* const label = new ElidedLabel(this);
  label->setObjectName("pictureAccuracy");
  label->setContentsMargins(10, 0, 0, 0);
  label->hide();
  setInk(label, Ink::quiet);
  statusBar()->insertPermanentWidget(1, label);  // the text under the pointer gives way first
  connect(accuracy, &AccuracyPanel::pictureKnown, label,
          [label](const QString& text, const QString& meaning) {
            label->setText(text);
            label->setToolTip(meaning);
            label->setVisible(!text.isEmpty());
          });
}

void MainWindow::tellAccuracy() {
  auto* const accuracy = panel<AccuracyPanel>();
  accuracy->setComplete(viewport_->complete());
  using Pixels = std::function<QImage()>;
  accuracy->setPixels(viewport_->complete() ? Pixels([this] { return viewport_->shown(); }) : Pixels(),
                      viewport_->legend());
  const VolumePointer& volume = document_->volume();
  const bool isLevel = volume && document_->shownLevel() > 0;
  fullResolution_->setSource(isLevel ? std::optional(document_->scene().source) : std::nullopt);
  if (isLevel && viewport_->complete() && !previewing_) {
    const scene::Scene resolved = document_->resolvedScene();
    levelMarks_->show(LevelMarks::Shown{volume, resolved, viewport_->shown(), viewport_->legend()});
    fullResolution_->show(FullResolutionView::Shown{document_->shownScene(), resolved, viewport_->shown(),
                                                    viewport_->devicePixelRatioF()});
  } else {
    levelMarks_->show({});
    fullResolution_->show({});
  }
  if (isLevel) showLevel();
}

void MainWindow::preview(const std::optional<scene::Scene>& scene) {
  const VolumePointer& volume = document_->volume();
  previewing_ = scene && volume;
  if (previewing_)
    viewport_->setScene(*scene, document_->resolved(*scene));
  else
    viewport_->setScene(document_->scene(), document_->resolvedScene());
  tellAccuracy();
  panel<AccuracyPanel>()->setPreviewing(previewing_);
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
