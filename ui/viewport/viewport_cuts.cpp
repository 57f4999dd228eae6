// Handles of cuts of ui/viewport/viewport.h: dragging one edits clip., as one step of undo.

#include "app/cuts/cut_drag.h"
#include "scene/rules/needs.h"
#include "ui/viewport/viewport.h"
#include "ui/viewport/viewport_overlay.h"
#include "volume/slice/slice_plane.h"

namespace isolux::ui {

void Viewport::setCutHandles(bool shown) {
  cutHandles_ = shown;
  showCuts();
}

app::CutStage Viewport::cutStage() const {
  return app::cutStageOf(resolved_, volume_->grid().geometry(), {width(), height()});
}

// Clicks of a tool for marks are meant for the surface.
void Viewport::showCuts() {
  const bool any = scene::hasCuts(resolved_.clip);
  cuts_.clear();
  if (volume_ && cutHandles_ && !tool_ && any) cuts_ = app::cutShapes(resolved_.clip, cutStage());
  overlay_->setCuts(cuts_, cutGrip_);
}

std::optional<app::CutGrip> Viewport::cutUnder(QPointF position) const {
  return app::cutAt(cuts_, {position.x(), position.y()});
}

void Viewport::hoverCut(const std::optional<app::CutGrip>& grip) {
  if (grip == cutGrip_) return;
  cutGrip_ = grip;
  if (!grip) {
    showNoGrip();
  } else {
    setCursor(Qt::OpenHandCursor);
    setToolTip(cutTip(*grip));
  }
  showCuts();
}

QString Viewport::cutTip(const app::CutGrip& grip) {
  if (grip.plane > 0)
    return grip.part == app::CutPart::turn
               ? tr("Plane %1: drag to turn it; Ctrl snaps to the axes and halfway between").arg(grip.plane)
               : tr("Plane %1: drag or use the wheel to move it along its normal; right click for the menu")
                     .arg(grip.plane);
  if (grip.part == app::CutPart::turn)
    return tr("Box: drag to turn it; Ctrl turns about one of its axes; right click for the menu");
  if (grip.part == app::CutPart::face) return tr("Box: drag this face or use the wheel to move it");
  return tr("Box: drag to move it parallel to the screen; right click for the menu");
}

void Viewport::takeCut() {
  cutFrom_ = scene_.clip;
  cutStage_ = cutStage();
  setCursor(Qt::ClosedHandCursor);
  showCuts();
}

void Viewport::dragCut(QPointF position, bool constrained) {
  if (!volume_ || !cutGrip_ || !app::hasGrip(scene_.clip, *cutGrip_)) return;  // removed meanwhile
  const glm::dvec2 from(pressed_.x(), pressed_.y()), to(position.x(), position.y());
  sendCut(app::draggedCut(cutFrom_, *cutGrip_, cutStage_, from, to, constrained), *cutGrip_, false);
  dragMoved_ = true;
  last_ = position;
}

// The cut is as it was: the gesture leaves no step.
void Viewport::cancelCut() {
  if (dragMoved_ && cutGrip_) sendCut(cutFrom_, *cutGrip_, false);
  endDrag(last_);
}

void Viewport::stepCut(const app::CutGrip& grip, double notches) {
  const app::CutStage stage = cutStage();
  glm::dvec3 normal = stage.frame.back;
  if (grip.plane > 0)
    normal = resolved_.clip.planes[static_cast<std::size_t>(grip.plane - 1)].normal;
  else if (grip.part == app::CutPart::face)
    normal = app::turnedBox(resolved_.clip, grip.plane).axes[grip.index / 2];
  const double voxelMm = volume::voxelAlong(volume_->grid().geometry(), glm::normalize(normal));
  sendCut(app::steppedCut(scene_.clip, grip, stage, notches * voxelMm), grip, true);
}

void Viewport::sendCut(const scene::Clip& clip, const app::CutGrip& grip, bool endsAfterPause) {
  if (clip == scene_.clip) return;
  const bool turns = grip.part == app::CutPart::turn;
  const QString name = grip.plane > 0 ? (turns ? tr("Turn plane %1") : tr("Move plane %1")).arg(grip.plane)
                       : turns        ? tr("Turn the box")
                       : grip.part == app::CutPart::face ? tr("Move a face of the box")
                                                         : tr("Move the box");
  Edit edit{scene_, name, QString("cut %1 %2").arg(grip.plane).arg(static_cast<int>(grip.part)),
            endsAfterPause};
  edit.scene.clip = clip;
  Q_EMIT edited(edit);
}

}  // namespace isolux::ui
