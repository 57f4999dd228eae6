// Mouse, wheel and keys of ui/slices/slice_view.h.
#include <algorithm>
#include <cmath>
#include <utility>

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QWheelEvent>

#include "ui/slices/slice_view.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

namespace {

constexpr double mostZoom = 64.0, notch = 120.0, zoomStep = 1.25;
constexpr int clickPixels = 4;        // a press that moves no farther is a click
constexpr double panFraction = 0.05;  // of the view, by a key

}  // namespace

void SliceView::moveTo(glm::dvec3 world, bool endsAfterPause) {
  Edit edit{scene_, tr("Move crosshair"), endsAfterPause ? "slice keys" : "slice position", endsAfterPause};
  edit.scene.slice.position = app::crosshairAt(choice(), resolved_, volume_->grid().geometry(), world);
  Q_EMIT edited(edit);
}

void SliceView::step(double voxels) {
  const bool cut = choice().kind == app::SliceChoice::Kind::cut;
  Edit edit{scene_, cut ? tr("Move cut") : tr("Move crosshair"), "slice wheel", true};
  app::stepPlane(edit.scene, choice(), resolved_, volume_->grid().geometry(), volume_->volume.axes, voxels);
  Q_EMIT edited(edit);
}

// A drag across the view changes the width about twentyfold, the level by the width.
void SliceView::dragWindow(QPointF step) {
  const volume::GreyWindow now = volume::greyWindow(resolved_.slice, volume_->histogram);
  Edit edit{scene_, tr("Change window level and width"), "slice window", false};
  edit.scene.slice.level = now.level + now.width * step.y() / std::max(1, height());
  edit.scene.slice.width = now.width * std::exp(3.0 * step.x() / std::max(1, width()));
  Q_EMIT edited(edit);
}

void SliceView::openMenu(QPointF place) {
  QMenu* const menu = makeSliceMenu(*this, worldAt(place));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->popup(mapToGlobal(place).toPoint());
}

void SliceView::mousePressEvent(QMouseEvent* event) {
  if (!volume_ || drag_ != Drag::none) return;
  const bool left = event->button() == Qt::LeftButton;
  if (event->button() == Qt::RightButton)
    drag_ = Drag::window;
  else if (event->button() == Qt::MiddleButton || (left && event->modifiers() & Qt::ShiftModifier))
    drag_ = Drag::pan;
  else if (left)
    drag_ = Drag::position;
  else
    return;
  moved_ = false;
  last_ = event->position();
  Q_EMIT gestureBegan();
  if (drag_ == Drag::position) moveTo(worldAt(last_), false);
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
  if (drag_ == Drag::none || !volume_) return;
  const QPointF step = event->position() - last_;
  if (drag_ == Drag::window && !moved_ && step.manhattanLength() < clickPixels) return;
  moved_ = true;
  last_ = event->position();
  if (drag_ == Drag::position)
    moveTo(worldAt(last_), false);
  else if (drag_ == Drag::pan)
    pan(step);
  else
    dragWindow(step);
}

void SliceView::mouseReleaseEvent(QMouseEvent* event) {
  const Drag was = std::exchange(drag_, Drag::none);
  if (was == Drag::none) return;
  if (was == Drag::window && !moved_ && volume_) openMenu(event->position());
  Q_EMIT gestureEnded();
}

// The mouse asks by the button's release: its press may begin a drag.
void SliceView::contextMenuEvent(QContextMenuEvent* event) {
  if (event->reason() == QContextMenuEvent::Keyboard && volume_) openMenu(QRectF(rect()).center());
}

void SliceView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) showWhole();
}

void SliceView::zoom(QPointF place, double factor) {
  const glm::dvec3 under = worldAt(place);
  const glm::dvec3 middle = worldAt(QRectF(rect()).center());
  const double before = zoom_;
  zoom_ = std::clamp(zoom_ * factor, 1.0, mostZoom);
  middle_ = under + (middle - under) * (before / zoom_);
  if (zoom_ == 1.0) middle_.reset();
  showAnew();
}

// The picture goes with the pointer; its middle stays in the volume.
void SliceView::pan(QPointF step) {
  const glm::dvec3 middle = worldAt(QRectF(rect()).center() - step);
  middle_ = app::crosshairAt({.kind = app::SliceChoice::Kind::oblique}, resolved_, volume_->grid().geometry(),
                             middle);
  showAnew();
}

void SliceView::wheelEvent(QWheelEvent* event) {
  event->accept();
  if (!volume_) return;
  const double notches = event->angleDelta().y() / notch;
  if (event->modifiers() & Qt::ControlModifier) {
    zoom(event->position(), std::pow(zoomStep, notches));
    return;
  }
  steps_ += notches;
  const double whole = std::trunc(steps_);
  if (whole == 0.0) return;
  steps_ -= whole;
  step(whole);
}

bool SliceView::takeKey(QKeyEvent* event) {
  const QPointF middle = QRectF(rect()).center();
  const glm::dvec2 arrow = arrowOf(event->key());
  switch (event->key()) {
    case Qt::Key_PageUp:
      step(1.0);
      return true;
    case Qt::Key_PageDown:
      step(-1.0);
      return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      zoom(middle, zoomStep);
      return true;
    case Qt::Key_Minus:
      zoom(middle, 1.0 / zoomStep);
      return true;
    case Qt::Key_Home:
      showWhole();
      return true;
    default:
      if (arrow == glm::dvec2(0.0)) return false;
  }
  if (event->modifiers() & Qt::ShiftModifier) {
    pan(QPointF(arrow.x * width(), -arrow.y * height()) * panFraction);
    return true;
  }
  const volume::SliceFrame frame = plane()->frame();
  const glm::dvec3 along = arrow.x * frame.right - arrow.y * frame.down;
  moveTo(position() + along * volume::voxelAlong(volume_->grid().geometry(), along), true);
  return true;
}

void SliceView::keyPressEvent(QKeyEvent* event) {
  const bool plain = !(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
  if (!volume_ || !plain || !takeKey(event)) QWidget::keyPressEvent(event);
}

}  // namespace isolux::ui
