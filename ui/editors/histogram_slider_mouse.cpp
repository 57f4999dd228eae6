// Mouse and keys of ui/editors/histogram_slider.h.
#include <algorithm>
#include <cmath>
#include <utility>

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QToolTip>
#include <QWheelEvent>

#include "base/numbers.h"
#include "ui/editors/histogram_slider.h"

namespace isolux::ui {

namespace {
constexpr double grabPixels = 8.0;

// The one whose line is within `reach` pixels of x, the nearest; null: none.
const PlacedHandle* handleAt(const std::vector<PlacedHandle>& handles, double x, double reach) {
  const PlacedHandle* best = nullptr;
  for (const PlacedHandle& placed : handles) {
    const double distance = std::abs(placed.x - x), other = best ? std::abs(best->x - x) : reach;
    const bool nearer = best ? distance < other || (distance == other && placed.active) : distance <= reach;
    if (nearer) best = &placed;
  }
  return best;
}

}  // namespace

void HistogramSlider::moveTo(double value) {
  const double step = base::niceBelow(plot_.shownRange() / std::max(1.0, plotArea().width()));
  value = std::clamp(base::roundedToStep(value, step), plot_.minimum(), plot_.maximum());
  if (value == valueOf(active_)) return;
  setActiveValue(value);
  pending_ = value;
  if (!sendTimer_.isActive()) sendTimer_.start();
  update();
}

void HistogramSlider::sendPending() {
  sendTimer_.stop();
  if (const auto value = std::exchange(pending_, std::nullopt)) emitActive(*value, false);
}

void HistogramSlider::nudge(double steps) {
  if (!volume_ || steps == 0.0) return;
  const double step = plot_.fineStep();
  const double value = std::clamp(base::roundedToStep(valueOf(active_) + steps * step, step), plot_.minimum(),
                                  plot_.maximum());
  setActiveValue(value);
  plot_.reveal(value);
  update();
  emitActive(value, true);
}

// In steps of what a pixel is.
double HistogramSlider::valueUnder(double x) const {
  const double step = base::niceBelow(plot_.shownRange() / std::max(1.0, plotArea().width()));
  return base::roundedToStep(plot_.valueAt(x - plotArea().left(), plotArea().width()), step);
}

void HistogramSlider::mousePressEvent(QMouseEvent* event) {
  if (!volume_ || dragging_ || panning_) return;
  const double x = event->position().x();
  if (event->button() == Qt::LeftButton && event->modifiers() & Qt::AltModifier) {
    Q_EMIT surfaceWanted(std::clamp(valueUnder(x), plot_.minimum(), plot_.maximum()));
  } else if (event->button() == Qt::LeftButton) {
    const std::vector<PlacedHandle> placed = placedHandles();
    if (const PlacedHandle* held = handleAt(placed, x, grabPixels)) active_ = held->handle->number;
    const double line = linePosition(active_).x();
    grabOffset_ = std::abs(event->position().x() - line) <= grabPixels ? line - event->position().x() : 0.0;
    dragging_ = true;
    Q_EMIT dragStarted();
    if (grabOffset_ == 0.0)
      moveTo(plot_.valueAt(event->position().x() - plotArea().left(), plotArea().width()));
  } else if (event->button() == Qt::MiddleButton) {
    panning_ = true;
    panPixel_ = event->position().x();
    setCursor(Qt::ClosedHandCursor);
  }
}

void HistogramSlider::mouseMoveEvent(QMouseEvent* event) {
  if (!volume_) return;
  if (dragging_ && !(event->buttons() & Qt::LeftButton)) endDrag();  // it was let go elsewhere
  if (panning_ && !(event->buttons() & Qt::MiddleButton)) endPan();
  const QRectF area = plotArea();
  const double x = event->position().x();
  if (dragging_) {
    hovered_.reset();
    moveTo(plot_.valueAt(x + grabOffset_ - area.left(), area.width()));
  } else if (panning_) {
    plot_.pan((panPixel_ - x) * plot_.shownRange() / area.width());
    panPixel_ = x;
    update();
  } else {
    const bool onLine = handleAt(placedHandles(), x, grabPixels) != nullptr;
    setCursor(onLine ? Qt::SplitHCursor : Qt::ArrowCursor);
    hovered_.reset();
    if (!onLine && x >= area.left() && x <= area.right()) hovered_ = valueUnder(x);
    update();
  }
}

void HistogramSlider::mouseReleaseEvent(QMouseEvent* event) {
  if (dragging_ && event->button() == Qt::LeftButton) {
    endDrag();
  } else if (panning_ && event->button() == Qt::MiddleButton) {
    endPan();
  }
}

void HistogramSlider::endDrag() {
  sendPending();
  dragging_ = false;
  Q_EMIT dragEnded();
}

void HistogramSlider::endPan() {
  panning_ = false;
  unsetCursor();
}

void HistogramSlider::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && volume_) Q_EMIT suggestionWanted();
}

void HistogramSlider::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  if (!volume_ || notches == 0.0) return;
  if (event->modifiers() & Qt::ControlModifier) {
    plot_.zoom(std::pow(1.25, notches),
               plot_.valueAt(event->position().x() - plotArea().left(), plotArea().width()));
    wantDetail();
    zoomed();
  } else {
    nudge(event->modifiers() & Qt::ShiftModifier ? 10.0 * notches : notches);
  }
  event->accept();
}

void HistogramSlider::keyPressEvent(QKeyEvent* event) {
  const double factor = event->modifiers() & Qt::ShiftModifier ? 10.0 : 1.0;
  switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Down:
      return nudge(-factor);
    case Qt::Key_Right:
    case Qt::Key_Up:
      return nudge(factor);
    case Qt::Key_PageDown:
      return nudge(-50.0 * factor);
    case Qt::Key_PageUp:
      return nudge(50.0 * factor);
    default:
      QWidget::keyPressEvent(event);
  }
}

void HistogramSlider::contextMenuEvent(QContextMenuEvent* event) {
  if (!volume_ || dragging_) return;
  const double value = std::clamp(valueUnder(event->pos().x()), plot_.minimum(), plot_.maximum());
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction(tr("Add isosurface at %1").arg(text(value)), this,
                  [this, value] { Q_EMIT surfaceWanted(value); });
  menu->addAction(tr("Suggested isovalue"), this, &HistogramSlider::suggestionWanted);
  menu->addAction(tr("Whole range"), this, &HistogramSlider::showAll)->setEnabled(plot_.zoomed());
  menu->popup(event->globalPos());
}

// Over a line its name: labels have room for the value only.
bool HistogramSlider::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip || !volume_) return QWidget::event(event);
  const auto* const help = static_cast<QHelpEvent*>(event);
  const std::vector<PlacedHandle> placed = placedHandles();
  const PlacedHandle* const under = handleAt(placed, help->pos().x(), grabPixels);
  if (under && handles_.size() > 1)
    QToolTip::showText(help->globalPos(), under->handle->name + QStringLiteral("  ") + under->label, this);
  else
    QToolTip::hideText();
  return true;
}

void HistogramSlider::leaveEvent(QEvent*) {
  hovered_.reset();
  update();
}

}  // namespace isolux::ui
