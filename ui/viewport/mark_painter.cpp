#include "ui/viewport/overlay_painters.h"

#include <algorithm>
#include <optional>

#include <QPainter>
#include <QPainterPath>

#include "ui/widgets/color_button.h"

namespace isolux::ui {

namespace {

constexpr double dotRadius = 4.5, faint = 0.38, labelGap = 11.0;
const QColor markRim(8, 10, 12, 205);

std::optional<QPointF> placeOf(const scene::CameraFrame& frame, glm::dvec3 world, QSizeF size) {
  const auto pixel = app::pixelOf(frame, world, {size.width(), size.height()});
  // Far outside, painters lose their precision.
  if (!pixel || std::max(std::abs(pixel->x), std::abs(pixel->y)) > 1e5) return std::nullopt;
  return QPointF(pixel->x, pixel->y);
}

bool isHidden(const app::MarkLine& line, std::size_t corner) {
  return corner < line.hidden.size() && line.hidden[corner];
}

void paintLine(QPainter& painter, const app::MarkLine& line, const QColor& colour,
               const scene::CameraFrame& frame, QSizeF size) {
  // Corners that follow one another and are seen alike are one stroke, so that dashes run on.
  for (std::size_t i = 1; i < line.corners.size();) {
    const bool behind = isHidden(line, i - 1) && isHidden(line, i);
    QPainterPath path;
    bool drawn = false;
    for (; i < line.corners.size() && (isHidden(line, i - 1) && isHidden(line, i)) == behind; ++i) {
      const auto from = placeOf(frame, line.corners[i - 1], size), to = placeOf(frame, line.corners[i], size);
      if (!from || !to) continue;
      if (!drawn || path.currentPosition() != *from) path.moveTo(*from);
      path.lineTo(*to);
      drawn = true;
    }
    if (!drawn) continue;
    painter.setOpacity(behind ? faint : 1.0);
    painter.setBrush(Qt::NoBrush);
    if (line.onSurface) {
      painter.setPen(QPen(markRim, 4.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      painter.drawPath(path);
    }
    QPen pen(line.onSurface ? colour : markRim, line.onSurface ? 2.4 : 3.6, Qt::SolidLine, Qt::FlatCap,
             Qt::RoundJoin);
    if (!line.onSurface) pen.setDashPattern({6.0 / 3.6, 4.0 / 3.6});
    painter.setPen(pen);
    painter.drawPath(path);
    if (line.onSurface) continue;
    pen.setColor(colour);
    pen.setWidthF(1.8);
    pen.setDashPattern({6.0 / 1.8, 4.0 / 1.8});
    painter.setPen(pen);
    painter.drawPath(path);
  }
}

void paintDots(QPainter& painter, const app::MarkLine& points, const QColor& colour,
               const scene::CameraFrame& frame, QSizeF size) {
  for (std::size_t i = 0; i < points.corners.size(); ++i) {
    const auto at = placeOf(frame, points.corners[i], size);
    if (!at) continue;
    painter.setOpacity(isHidden(points, i) ? faint : 1.0);
    painter.setPen(QPen(markRim, 1.6));
    painter.setBrush(colour);
    painter.drawEllipse(*at, dotRadius, dotRadius);
  }
}

// Beside the anchor where nothing is covered: right, left, above, below, then further up and down.
QRectF labelPlace(QPointF anchor, QSizeF label, QSizeF picture, const std::vector<QRectF>& taken) {
  const double w = label.width(), h = label.height();
  std::vector<QRectF> tries;
  for (const double lift : {0.0, 1.2, -1.2, 2.4, -2.4, 3.6, -3.6}) {
    const double y = anchor.y() - 0.5 * h + lift * h;
    tries.emplace_back(anchor.x() + labelGap, y, w, h);
    tries.emplace_back(anchor.x() - labelGap - w, y, w, h);
    if (lift != 0.0) tries.emplace_back(anchor.x() - 0.5 * w, y, w, h);
  }
  const QRectF all(QPointF(2.0, 2.0), picture - QSizeF(4.0, 4.0));
  const auto isFree = [&](const QRectF& place) {
    return all.contains(place) && std::none_of(taken.begin(), taken.end(),
                                               [&](const QRectF& other) { return other.intersects(place); });
  };
  const auto found = std::find_if(tries.begin(), tries.end(), isFree);
  return found == tries.end() ? tries.front() : *found;
}

void paintLabel(QPainter& painter, const QRectF& place, const QString& text, const QColor& colour) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(16, 18, 22, 200));
  painter.drawRoundedRect(place, 4.0, 4.0);
  painter.setBrush(colour);
  painter.drawRoundedRect(QRectF(place.left(), place.top(), 3.0, place.height()), 1.5, 1.5);
  painter.setPen(QColor(0xf4, 0xf6, 0xf8));
  painter.drawText(place.adjusted(8.0, 0.0, -5.0, 0.0), Qt::AlignVCenter | Qt::AlignLeft, text);
}

}  // namespace

std::vector<QRectF> paintMarks(QPainter& painter, const std::vector<app::MarkShape>& marks,
                               const scene::CameraFrame& frame, QSizeF size, std::vector<QRectF> taken) {
  constexpr double widestLabel = 340.0;
  painter.save();
  std::vector<QRectF> labels;
  for (const app::MarkShape& mark : marks) {
    const QColor colour = screenColour(mark.color);
    for (const app::MarkLine& line : mark.lines) paintLine(painter, line, colour, frame, size);
  }
  for (const app::MarkShape& mark : marks) {
    paintDots(painter, mark.points, screenColour(mark.color), frame, size);
    for (const glm::dvec3& point : mark.points.corners)
      if (const auto at = placeOf(frame, point, size))
        taken.emplace_back(at->x() - dotRadius, at->y() - dotRadius, 2 * dotRadius, 2 * dotRadius);
  }
  const QFontMetricsF metrics(painter.font());
  for (const app::MarkShape& mark : marks) {
    const auto anchor = placeOf(frame, mark.anchor, size);
    const QRectF picture(QPointF(0.0, 0.0), size);
    labels.emplace_back();
    if (!anchor || mark.label.empty() || !picture.contains(*anchor)) continue;
    const QString text = metrics.elidedText(QString::fromStdString(mark.label), Qt::ElideRight, widestLabel);
    const QSizeF extent(metrics.horizontalAdvance(text) + 14.0, metrics.height() + 4.0);
    const bool hidden =
        !mark.points.hidden.empty() &&
        std::all_of(mark.points.hidden.begin(), mark.points.hidden.end(), [](bool behind) { return behind; });
    labels.back() = labelPlace(*anchor, extent, size, taken);
    taken.push_back(labels.back());
    painter.setOpacity(hidden ? 0.6 : 1.0);
    paintLabel(painter, labels.back(), text, screenColour(mark.color));
  }
  painter.restore();
  return labels;
}

}  // namespace isolux::ui
