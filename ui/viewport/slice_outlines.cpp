#include "ui/viewport/slice_outlines.h"

#include <utility>

#include <QPainter>

#include "app/interaction/mark_view.h"

namespace isolux::ui {

namespace {

constexpr double crossArm = 9.0, crossOpen = 3.0;  // pixels

void strokeOnDark(QPainter& painter, const QLineF& line, const QColor& color, double width) {
  for (const auto& [ink, thick] : {std::pair{QColor(0, 0, 0, 110), width + 2.0}, std::pair{color, width}}) {
    painter.setPen(QPen(ink, thick, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(line);
  }
}

}  // namespace

void paintSlices(QPainter& painter, const SlicesInPicture& slices, const scene::CameraFrame& frame,
                 QSizeF size) {
  if (slices.outlines.empty()) return;
  const glm::dvec2 pixels(size.width(), size.height());
  const auto place = [&](glm::dvec3 world) { return app::pixelOf(frame, world, pixels); };
  for (const SliceOutline& outline : slices.outlines)
    for (std::size_t i = 0; i < outline.corners.size(); ++i) {
      const auto from = place(outline.corners[i]),
                 to = place(outline.corners[(i + 1) % outline.corners.size()]);
      if (from && to) strokeOnDark(painter, {from->x, from->y, to->x, to->y}, outline.color, 1.3);
    }
  const auto cross = place(slices.crosshairMm);
  if (!cross) return;
  const QPointF at(cross->x, cross->y);
  for (const QPointF way : {QPointF(1.0, 0.0), QPointF(-1.0, 0.0), QPointF(0.0, 1.0), QPointF(0.0, -1.0)})
    strokeOnDark(painter, {at + crossOpen * way, at + crossArm * way}, QColor(255, 255, 255), 1.8);
}

}  // namespace isolux::ui
