#include "ui/viewport/overlay_painters.h"

#include <utility>

#include <QPainter>

#include "app/view_math/mark_view.h"

namespace isolux::ui {

namespace {

constexpr double crossArm = 9.0, crossOpen = 3.0;  // pixels

void strokeOnDark(QPainter& painter, const QLineF& line, const QColor& color, double width) {
  for (const auto& [ink, thick] : {std::pair{QColor(0, 0, 0, 110), width + 2.0}, std::pair{color, width}}) {
    painter.setPen(QPen(ink, thick, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(line);
  }
}

std::vector<QLineF> edgesOf(const SliceOutline& outline, const scene::CameraFrame& frame, QSizeF size) {
  const glm::dvec2 pixels(size.width(), size.height());
  std::vector<QLineF> edges;
  for (std::size_t i = 0; i < outline.corners.size(); ++i) {
    const auto from = app::pixelOf(frame, outline.corners[i], pixels),
               to = app::pixelOf(frame, outline.corners[(i + 1) % outline.corners.size()], pixels);
    if (from && to) edges.emplace_back(from->x, from->y, to->x, to->y);
  }
  return edges;
}

}  // namespace

std::vector<QLineF> sliceLines(const SlicesInPicture& slices, const scene::CameraFrame& frame, QSizeF size) {
  std::vector<QLineF> lines;
  for (const SliceOutline& outline : slices.outlines)
    for (const QLineF& edge : edgesOf(outline, frame, size)) lines.push_back(edge);
  return lines;
}

void paintSlices(QPainter& painter, const SlicesInPicture& slices, const scene::CameraFrame& frame,
                 QSizeF size) {
  if (slices.outlines.empty()) return;
  for (const SliceOutline& outline : slices.outlines)
    for (const QLineF& edge : edgesOf(outline, frame, size)) strokeOnDark(painter, edge, outline.color, 1.3);
  const auto cross = app::pixelOf(frame, slices.crosshairMm, {size.width(), size.height()});
  if (!cross) return;
  const QPointF at(cross->x, cross->y);
  for (const QPointF way : {QPointF(1.0, 0.0), QPointF(-1.0, 0.0), QPointF(0.0, 1.0), QPointF(0.0, -1.0)})
    strokeOnDark(painter, {at + crossOpen * way, at + crossArm * way}, QColor(255, 255, 255), 1.8);
}

}  // namespace isolux::ui
