// A one-dimensional transfer function (look.colormap_points, look.accessibility_points) as a colour bar with
// its control points.
//
// A click on the bar adds a point, a drag moves it between its neighbours. Keys: Tab to the next point,
// arrows move by hundredths, Insert or Enter adds one behind the selected point. Two always stay.
#pragma once

#include "ui/editors/points_editor.h"

namespace isolux::ui {

class ColorPointsView : public PointsView {
  Q_OBJECT
 public:
  explicit ColorPointsView(QWidget* parent);

  void addAnother() override;  // halfway to the next point, of the last one to the point before
  QPointF positionOf(glm::dvec2 at) const override;
  glm::dvec2 placeAt(QPointF position) const override;
  QString addTip() const override;

 protected:
  glm::dvec2 reachable(glm::dvec2 at, std::size_t index) const override;  // between its neighbours
  std::size_t indexOfNew(glm::dvec2 at) const override;
  glm::dvec3 colorAt(glm::dvec2 at) const override;
  QImage pictureOf(const std::vector<MapPoint>& points) const override;
  QRectF area() const override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  bool focusNextPrevChild(bool next) override;
};

}  // namespace isolux::ui
