#include "ui/editors/histogram_handles.h"

#include <algorithm>
#include <cmath>

#include <QFontMetricsF>
#include <QPainter>

namespace isolux::ui {

namespace {

constexpr double labelTop = 1.0, labelHeight = 18.0, markWidth = 10.0;

QRectF labelBox(const PlacedHandle& placed, const QRectF& area, double width, const QFontMetricsF& metrics) {
  const double boxWidth = metrics.horizontalAdvance(placed.label) + 14.0;
  QRectF box(std::clamp(placed.x, area.left(), area.right()) - 0.5 * boxWidth, labelTop, boxWidth,
             labelHeight);
  box.moveLeft(std::clamp(box.left(), 1.0, std::max(1.0, width - 1.0 - boxWidth)));
  return box;
}

}  // namespace

void paintHandles(QPainter& painter, const QRectF& area, double width, const QFont& font,
                  std::vector<PlacedHandle> handles) {
  std::stable_partition(handles.begin(), handles.end(), [](const auto& placed) { return !placed.active; });
  const QFontMetricsF metrics(font);
  painter.setFont(font);
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const PlacedHandle& placed = handles[i];
    QRectF box = labelBox(placed, area, width, metrics);
    const bool covered = std::any_of(
        handles.begin() + static_cast<std::ptrdiff_t>(i) + 1, handles.end(),
        [&](const PlacedHandle& later) { return labelBox(later, area, width, metrics).intersects(box); });
    const double x = std::clamp(placed.x, area.left(), area.right());
    if (covered) box = QRectF(x - 0.5 * markWidth, labelTop + labelHeight - markWidth, markWidth, markWidth);
    QColor colour = placed.handle->colour;
    colour.setAlphaF(placed.handle->shown ? 1.0F : 0.45F);
    if (placed.x >= area.left() - 0.5 && placed.x <= area.right() + 0.5) {
      painter.setPen(QPen(colour, 2.0, placed.handle->shown ? Qt::SolidLine : Qt::DashLine));
      painter.drawLine(QPointF(x, box.bottom()), QPointF(x, area.bottom()));
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawRoundedRect(box, 4.0, 4.0);
    if (covered) continue;
    const bool bright = 0.3 * colour.redF() + 0.59 * colour.greenF() + 0.11 * colour.blueF() > 0.5;
    painter.setPen(bright ? QColor(0x22, 0x1a, 0x08) : QColor(0xf4, 0xf6, 0xf8));
    painter.drawText(box, Qt::AlignCenter, placed.label);
  }
}

const PlacedHandle* handleAt(const std::vector<PlacedHandle>& handles, double x, double reach) {
  const PlacedHandle* best = nullptr;
  for (const PlacedHandle& placed : handles) {
    const double distance = std::abs(placed.x - x), other = best ? std::abs(best->x - x) : reach;
    const bool nearer = best ? distance < other || (distance == other && placed.active) : distance <= reach;
    if (nearer) best = &placed;
  }
  return best;
}

}  // namespace isolux::ui
