#include "ui/viewport/overlay_painters.h"

#include <QPainter>
#include <QPainterPath>

#include <glm/geometric.hpp>

#include "ui/theme/style.h"

namespace isolux::ui {

namespace {

constexpr double knobRadius = 9.0, tipLength = 15.0, tipHalf = 6.5, faceHalf = 5.5, cornerRadius = 4.5;
const QColor cutRim(0, 0, 0, 190), cutFill(0x2a, 0x2f, 0x37), cutInk(Qt::white);

QPointF pointOf(glm::dvec2 pixel) {
  return {pixel.x, pixel.y};
}

void strokeTwice(QPainter& painter, const QPainterPath& path, const QColor& ink, double width,
                 Qt::PenStyle style = Qt::SolidLine) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(cutRim, width + 2.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(path);
  painter.setPen(QPen(ink, width, style, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(path);
}

void paintOutline(QPainter& painter, const app::CutShape& shape, bool marked) {
  QPainterPath seen, hidden;
  for (const app::CutLine& line : shape.outline) {
    QPainterPath& path = line.far ? hidden : seen;
    path.moveTo(pointOf(line.from));
    path.lineTo(pointOf(line.to));
  }
  painter.setOpacity(0.5);
  strokeTwice(painter, hidden, cutInk, 1.0, Qt::DotLine);
  painter.setOpacity(marked ? 1.0 : 0.8);
  strokeTwice(painter, seen, marked ? colours.accent : cutInk, marked ? 2.2 : 1.3);
  painter.setOpacity(1.0);
}

// An arrow head whose point is a little beyond the knob's place.
QPainterPath tipOf(glm::dvec2 from, glm::dvec2 tip) {
  const glm::dvec2 along = glm::normalize(tip - from), across(-along.y, along.x);
  const glm::dvec2 base = tip - 0.5 * tipLength * along;
  QPainterPath path;
  path.moveTo(pointOf(tip + 0.5 * tipLength * along));
  path.lineTo(pointOf(base + tipHalf * across));
  path.lineTo(pointOf(base - tipHalf * across));
  path.closeSubpath();
  return path;
}

void fillKnob(QPainter& painter, const QPainterPath& path, const QColor& fill, bool marked, bool far) {
  painter.setOpacity(far && !marked ? 0.6 : 1.0);
  strokeTwice(painter, path, marked ? colours.accent : cutInk, marked ? 2.6 : 1.6);
  painter.fillPath(path, fill);
  painter.setOpacity(1.0);
}

void paintPlaneKnobs(QPainter& painter, const app::CutShape& shape, const std::optional<app::CutGrip>& grip) {
  if (shape.knobs.size() != 2) return;
  const app::CutKnob &knob = shape.knobs[0], &tip = shape.knobs[1];
  const auto held = [&](const app::CutKnob& one) { return grip && *grip == one.grip; };
  const auto arrow = [&] {
    QPainterPath shaft;
    shaft.moveTo(pointOf(knob.pixel));
    shaft.lineTo(pointOf(tip.pixel));
    strokeTwice(painter, shaft, cutInk, 1.8, tip.far ? Qt::DotLine : Qt::SolidLine);
    fillKnob(painter, tipOf(knob.pixel, tip.pixel), held(tip) ? colours.accent : cutInk, held(tip), tip.far);
  };
  if (tip.far) arrow();  // the knob lies before it
  QPainterPath disc;
  disc.addEllipse(pointOf(knob.pixel), knobRadius, knobRadius);
  if (!tip.far) arrow();
  fillKnob(painter, disc, cutFill, held(knob), false);
  QFont font = painter.font();
  font.setPixelSize(12);
  font.setWeight(QFont::DemiBold);
  painter.setFont(font);
  painter.setPen(cutInk);
  painter.drawText(
      QRectF(knob.pixel.x - knobRadius, knob.pixel.y - knobRadius, 2 * knobRadius, 2 * knobRadius),
      Qt::AlignCenter, QString::number(shape.plane));
}

void paintBoxKnobs(QPainter& painter, const app::CutShape& shape, const std::optional<app::CutGrip>& grip) {
  const auto paint = [&](const app::CutKnob& knob) {
    const bool held = grip && *grip == knob.grip;
    QPainterPath path;
    const QPointF at = pointOf(knob.pixel);
    if (knob.grip.part == app::CutPart::face) {
      path.addRoundedRect(QRectF(at - QPointF(faceHalf, faceHalf), QSizeF(2 * faceHalf, 2 * faceHalf)), 2, 2);
    } else if (knob.grip.part == app::CutPart::turn) {
      path.addEllipse(at, cornerRadius, cornerRadius);
    } else {  // a plus: to all sides
      path.addRect(QRectF(at.x() - 7.0, at.y() - 1.5, 14.0, 3.0));
      path.addRect(QRectF(at.x() - 1.5, at.y() - 7.0, 3.0, 14.0));
      path = path.simplified();
    }
    fillKnob(painter, path, held ? colours.accent : knob.far ? cutFill : cutInk, held, knob.far);
  };
  for (const bool far : {true, false})
    for (const app::CutKnob& knob : shape.knobs)
      if (knob.far == far) paint(knob);
}

}  // namespace

void paintCuts(QPainter& painter, const std::vector<app::CutShape>& shapes,
               const std::optional<app::CutGrip>& grip) {
  painter.save();
  for (const app::CutShape& shape : shapes) paintOutline(painter, shape, grip && grip->plane == shape.plane);
  for (const app::CutShape& shape : shapes)
    if (shape.plane <= 0)
      paintBoxKnobs(painter, shape, grip);
    else
      paintPlaneKnobs(painter, shape, grip);
  painter.restore();
}

}  // namespace isolux::ui
