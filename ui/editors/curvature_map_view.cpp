#include "ui/editors/curvature_map_view.h"

#include <algorithm>

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "scene/curvature_map.h"
#include "ui/theme/style.h"
#include "ui/widgets/color_button.h"

namespace isolux::ui {

namespace {

constexpr int texels = 96;  // of the picture of the map, per axis; drawn smoothly
constexpr double keyStep = 0.02;
// Room around the square for the names of the axes and of the shapes.
constexpr double left = 22.0, right = 52.0, top = 10.0, bottom = 42.0;
constexpr int largestSide = 200;

std::vector<scene::CurvaturePoint> curvaturePointsOf(const std::vector<MapPoint>& points) {
  std::vector<scene::CurvaturePoint> same;
  for (const MapPoint& point : points) same.push_back({point.at.x, point.at.y, point.color});
  return same;
}

std::vector<PointsView::Axis> kappas() {
  std::vector<PointsView::Axis> axes;
  for (const QString& name : {QString("κ₁"), QString("κ₂")})
    axes.push_back({name, name,
                    CurvatureMapView::tr("%1 of the selected point, as a fraction of the range").arg(name),
                    -1.0, keyStep});
  return axes;
}

}  // namespace

CurvatureMapView::CurvatureMapView(QWidget* parent) : PointsView(kappas(), 1, parent) {
  setFixedHeight(largestSide + static_cast<int>(top + bottom));
  setMinimumWidth(static_cast<int>(left + right) + largestSide / 2);
  setAccessibleName(tr("Colour map of the principal curvatures"));
  showPoints({MapPoint{}});
}

QString CurvatureMapView::addTip() const {
  return tr("Add a point (double click on the map)");
}

QRectF CurvatureMapView::area() const {
  const double side = std::max(std::min(width() - left - right, height() - top - bottom), 1.0);
  return {left, top, side, side};
}

QPointF CurvatureMapView::positionOf(glm::dvec2 kappa) const {
  const QRectF square = area();
  return {square.left() + 0.5 * (kappa.x + 1.0) * square.width(),
          square.bottom() - 0.5 * (kappa.y + 1.0) * square.height()};
}

glm::dvec2 CurvatureMapView::placeAt(QPointF position) const {
  const QRectF square = area();
  return {2.0 * (position.x() - square.left()) / square.width() - 1.0,
          2.0 * (square.bottom() - position.y()) / square.height() - 1.0};
}

// What can occur: kappa1 >= kappa2, both in the range. A point above the diagonal goes to the nearest on it.
glm::dvec2 CurvatureMapView::reachable(glm::dvec2 kappa, std::size_t) const {
  kappa = glm::clamp(kappa, -1.0, 1.0);
  if (kappa.y > kappa.x) kappa = glm::dvec2(0.5 * (kappa.x + kappa.y));
  return glm::round(kappa * 1000.0) / 1000.0;
}

glm::dvec3 CurvatureMapView::colorAt(glm::dvec2 kappa) const {
  return scene::curvatureColor(curvaturePointsOf(points()), kappa);
}

QImage CurvatureMapView::pictureOf(const std::vector<MapPoint>& points) const {
  QImage image(texels, texels, QImage::Format_RGB32);
  scene::Look look;
  look.curvaturePoints = curvaturePointsOf(points);
  const std::vector<glm::vec3> samples = scene::curvatureTexels(look, texels);
  for (int row = 0; row < texels; ++row)
    for (int column = 0; column < texels; ++column)
      image.setPixel(column, texels - 1 - row,
                     screenColour(samples[static_cast<std::size_t>(row * texels + column)]).rgb());
  return image;
}

void CurvatureMapView::addAnother() {
  constexpr int steps = 20;
  glm::dvec2 best{0.0};
  double most = -1.0;
  for (int i = -steps; i <= steps; ++i) {
    for (int j = -steps; j <= i; ++j) {
      const glm::dvec2 place = glm::dvec2(i, j) / static_cast<double>(steps);
      double nearest = 1e9;
      for (const MapPoint& point : points()) nearest = std::min(nearest, glm::distance(place, point.at));
      if (nearest <= most) continue;
      most = nearest;
      best = place;
    }
  }
  addPoint(best);
}

void CurvatureMapView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && pointAt(event->position()) < 0)
    addPoint(placeAt(event->position()));
}

void CurvatureMapView::paintOver(QPainter& painter) const {
  const QRectF square = area();
  QPainterPath never;
  never.addPolygon(QPolygonF({square.topLeft(), square.topRight(), square.bottomLeft(), square.topLeft()}));
  QColor veil = colours.base;
  veil.setAlpha(210);
  painter.fillPath(never, veil);
  painter.fillPath(never, QBrush(colours.border, Qt::BDiagPattern));
  PointsView::paintOver(painter);
  paintAxes(painter);
}

void CurvatureMapView::paintAxes(QPainter& painter) const {
  const QRectF square = area();
  painter.setPen(QPen(QColor(255, 255, 255, 70), 1.0));
  painter.drawLine(positionOf({0.0, 0.0}), positionOf({1.0, 0.0}));
  painter.drawLine(positionOf({0.0, 0.0}), positionOf({0.0, -1.0}));

  QFont small = font();
  small.setPointSizeF(0.86 * small.pointSizeF());
  painter.setFont(small);
  painter.setPen(colours.quietText);
  const double line = QFontMetricsF(small).height();
  const auto beside = [&](double kappa2, const QString& text) {
    const double y =
        std::clamp(positionOf({1.0, kappa2}).y() - 0.5 * line, square.top(), square.bottom() - line);
    painter.drawText(QRectF(square.right() + radius + 5.0, y, right, line), Qt::AlignLeft | Qt::AlignVCenter,
                     text);
  };
  const auto below = [&](double kappa1, const QString& text, Qt::Alignment side) {
    const double x = positionOf({kappa1, -1.0}).x();
    const double from = side == Qt::AlignLeft ? x : side == Qt::AlignRight ? x - 60.0 : x - 30.0;
    painter.drawText(QRectF(from, square.bottom() + radius + 3.0, 60.0, line), side | Qt::AlignTop, text);
  };
  beside(1.0, tr("cap"));
  beside(0.0, tr("ridge"));
  beside(-1.0, tr("saddle"));
  below(-1.0, tr("cup"), Qt::AlignLeft);
  below(0.0, tr("valley"), Qt::AlignHCenter);
  painter.setPen(colours.text);
  painter.drawText(QRectF(square.left(), square.bottom() + radius + 5.0 + line, square.width(), line),
                   Qt::AlignCenter, "κ₁  →");
  painter.save();
  painter.translate(0.0, square.bottom());
  painter.rotate(-90.0);
  painter.drawText(QRectF(0.0, 0.0, square.height(), left - 3.0), Qt::AlignCenter, "κ₂  →");
  painter.restore();
}

}  // namespace isolux::ui
