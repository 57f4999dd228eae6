#include "ui/slices/slice_painter.h"

#include <cmath>

#include <QPainter>
#include <QPainterPath>

#include <glm/geometric.hpp>

#include "base/color.h"

namespace isolux::ui {

namespace {

constexpr double openAbout = 8.0, dot = 3.5;  // units of the painter

QPointF unitOf(glm::dvec2 pixel, double ratio) {
  const glm::dvec2 place = (pixel + 0.5) / ratio;
  return {place.x, place.y};
}

void strokeOnRim(QPainter& painter, const QLineF& line, const QColor& color) {
  for (const auto& [ink, thick] : {std::pair{QColor(0, 0, 0, 140), 3.0}, std::pair{color, 1.0}}) {
    painter.setPen(QPen(ink, thick));
    painter.drawLine(line);
  }
}

}  // namespace

void paintPlanes(QPainter& painter, const volume::SlicePlane& picture, const std::vector<PlaneOfView>& planes,
                 glm::dvec3 crosshairMm, QSizeF border, double ratio) {
  const QRectF all(QPointF(0.0, 0.0), QSizeF(picture.size.x, picture.size.y) / ratio);
  const QPointF cross = unitOf(picture.pixelOf(crosshairMm), ratio);
  painter.save();
  painter.setClipRect(all.adjusted(border.width(), border.height(), -border.width(), -border.height()));
  for (const PlaneOfView& other : planes) {
    const auto ends = app::crossingLine(picture, other.plane);
    if (!ends) continue;
    const QLineF line(unitOf((*ends)[0], ratio), unitOf((*ends)[1], ratio));
    const bool straight = line.dx() == 0.0 || line.dy() == 0.0;
    painter.setRenderHint(QPainter::Antialiasing, !straight);
    const QPointF way = (line.p2() - line.p1()) / line.length();
    const double along = QPointF::dotProduct(cross - line.p1(), way);
    const QPointF foot = line.p1() + along * way;
    if (QLineF(foot, cross).length() > openAbout) {  // of a plane that the crosshair does not lie in
      strokeOnRim(painter, line, other.color);
      continue;
    }
    if (along > openAbout) strokeOnRim(painter, {line.p1(), foot - openAbout * way}, other.color);
    if (along < line.length() - openAbout)
      strokeOnRim(painter, {foot + openAbout * way, line.p2()}, other.color);
  }
  painter.restore();
}

void paintPoints(QPainter& painter, const volume::SlicePlane& picture, const std::vector<scene::Mark>& marks,
                 double reachMm, double ratio) {
  const glm::dvec3 normal = picture.frame().normal();
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const scene::Mark& mark : marks) {
    if (!mark.shown) continue;
    const QColor color(base::screenByte(mark.color.x), base::screenByte(mark.color.y),
                       base::screenByte(mark.color.z));
    for (const glm::dvec3& point : mark.points) {
      if (std::abs(glm::dot(point - picture.originMm, normal)) > reachMm) continue;
      const QPointF at = unitOf(picture.pixelOf(point), ratio);
      painter.setPen(QPen(QColor(0, 0, 0, 200), 1.5));
      painter.setBrush(color);
      painter.drawEllipse(at, dot, dot);
      if (mark.kind != scene::MarkKind::point) continue;
      QPainterPath name;
      name.addText(at + QPointF(2.0 * dot, -dot), painter.font(), QString::fromStdString(mark.name));
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(QColor(0, 0, 0, 200), 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      painter.drawPath(name);
      painter.fillPath(name, QColor(0xf4, 0xf6, 0xf8));
    }
  }
  painter.restore();
}

void paintStripe(QPainter& painter, int width, const QColor& color) {
  constexpr int high = 2;
  painter.fillRect(0, 0, width, high, color);
}

}  // namespace isolux::ui
