// The colour map over (kappa1, kappa2), look.curvature_points, as a square with its control points.
//
// A double click adds a point. One always stays. Kappas are in parts of the map's range. As
// kappa1 >= kappa2, points are kept on and below the diagonal; the half above it is hatched.
#pragma once

#include "ui/editors/points_editor.h"

namespace isolux::ui {

class CurvatureMapView : public PointsView {
  Q_OBJECT
 public:
  explicit CurvatureMapView(QWidget* parent);

  void addAnother() override;  // as far as possible from all others
  QPointF positionOf(glm::dvec2 kappa) const override;
  glm::dvec2 placeAt(QPointF position) const override;  // not clamped
  QString addTip() const override;

 protected:
  glm::dvec2 reachable(glm::dvec2 kappa, std::size_t index) const override;
  glm::dvec3 colorAt(glm::dvec2 kappa) const override;
  QImage pictureOf(const std::vector<MapPoint>& points) const override;
  QRectF area() const override;
  void paintOver(QPainter& painter) const override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;

 private:
  void paintAxes(QPainter& painter) const;
};

}  // namespace isolux::ui
