#include "ui/viewport/overlay_painters.h"

#include <QPainter>
#include <QPainterPath>

#include "ui/theme/style.h"
#include "ui/widgets/color_button.h"

namespace isolux::ui {

namespace {

constexpr double discRadius = 10.0, arrowLength = 13.0;
const QColor lampRim(0, 0, 0, 190);

void strokeRing(QPainter& painter, QPointF centre, double radius, const QColor& colour, bool marked,
                Qt::PenStyle style) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(lampRim, marked ? 5.0 : 3.5));
  painter.drawEllipse(centre, radius, radius);
  painter.setPen(QPen(colour, marked ? 2.6 : 1.4, style));
  painter.drawEllipse(centre, radius, radius);
}

// A triangle beyond the disc: the lamp is out there.
QPainterPath arrowFrom(QPointF centre, glm::dvec2 toward) {
  const QPointF along(toward.x, toward.y), across(-toward.y, toward.x);
  QPainterPath path;
  path.moveTo(centre + along * (discRadius + arrowLength));
  path.lineTo(centre + along * (discRadius + 3.5) + across * 6.0);
  path.lineTo(centre + along * (discRadius + 3.5) - across * 6.0);
  path.closeSubpath();
  return path;
}

void paintHandle(QPainter& painter, const app::LampHandle& handle, bool marked) {
  const QPointF centre(handle.pixel.x, handle.pixel.y);
  const QColor colour = screenColour(handle.color);
  const QColor line = marked ? colours.accent : QColor(Qt::white);
  painter.setPen(QPen(lampRim, marked ? 6.0 : 4.5));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(centre, discRadius, discRadius);
  if (handle.outside) {
    const QPainterPath arrow = arrowFrom(centre, handle.toward);
    painter.setPen(QPen(lampRim, 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(arrow);
    painter.fillPath(arrow, line);
  }
  // Behind the volume: the outline is dashed.
  painter.setPen(QPen(line, marked ? 2.6 : 1.8, handle.far ? Qt::DotLine : Qt::SolidLine));
  painter.setBrush(colour);
  painter.drawEllipse(centre, discRadius, discRadius);

  QFont font = painter.font();
  font.setPixelSize(13);
  font.setWeight(QFont::DemiBold);
  painter.setFont(font);
  painter.setPen(colour.lightnessF() > 0.45F ? QColor(0x14, 0x16, 0x1a) : QColor(Qt::white));
  painter.drawText(QRectF(centre.x() - discRadius, centre.y() - discRadius, 2 * discRadius, 2 * discRadius),
                   Qt::AlignCenter, QString::number(handle.number));
}

}  // namespace

void paintLamps(QPainter& painter, const std::vector<app::LampHandle>& handles,
                const std::optional<app::LampGrip>& grip) {
  for (const app::LampHandle& handle : handles) {
    const bool held = grip && grip->id == handle.id;
    const QPointF ball(handle.ballPixel.x, handle.ballPixel.y);
    // The ball of a distant lamp would only clutter a picture that nobody lights anew.
    if (handle.kind == scene::LampKind::directional && held && handle.ringPixels > 0.0)
      strokeRing(painter, ball, handle.ringPixels, QColor(255, 255, 255, 150), false, Qt::DashLine);
    if (handle.kind == scene::LampKind::sphere && handle.ringPixels > discRadius && !handle.outside)
      strokeRing(painter, ball, handle.ringPixels, screenColour(handle.color),
                 held && grip->part == app::LampPart::ring, Qt::SolidLine);
  }
  for (const app::LampHandle& handle : handles)
    paintHandle(painter, handle, grip && grip->id == handle.id && grip->part == app::LampPart::handle);
}

}  // namespace isolux::ui
