// Edits a colour map by its control points: a picture of the map with the points on it, and below it the
// colour and place of the selected one.
//
// Drag a point; Delete removes the selected one, arrow keys move it by a step. What else the mouse and keys
// do is said by the views: ui/editors/color_points_view.h, ui/editors/curvature_map_view.h.
#pragma once

#include <vector>

#include <QImage>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "ui/editors/value_widgets.h"

class QToolButton;

namespace isolux::ui {

class ColorButton;
class NumberSpinBox;

struct MapPoint {
  glm::dvec2 at{0.0};     // in a map over one quantity only x counts
  glm::dvec3 color{0.0};  // linear RGB
  bool operator==(const MapPoint&) const = default;
};

// The picture with its points.
class PointsView : public QWidget {
  Q_OBJECT
 public:
  // One of the quantities, one or two, over which the map gives a colour.
  struct Axis {
    QString name, title, tip;  // an empty name is not shown
    double minimum, step;      // keys move a point by a step; the maximum is 1
  };
  PointsView(std::vector<Axis> axes, std::size_t fewest, QWidget* parent);

  const std::vector<Axis>& axes() const { return axes_; }
  void showPoints(const std::vector<MapPoint>& points);
  const std::vector<MapPoint>& points() const { return points_; }
  int selected() const { return selected_; }  // an index into points()
  const MapPoint& selectedPoint() const { return points_[static_cast<std::size_t>(selected_)]; }
  void select(int index);

  void addPoint(glm::dvec2 at);   // in the colour that the map has there; selects it
  virtual void addAnother() = 0;  // where there is room
  void removeSelected();
  void replaceSelected(MapPoint point, bool endsAfterPause);  // goes no farther than it may
  bool canAdd() const;
  bool canRemove() const { return points_.size() > fewest_; }

  virtual QPointF positionOf(glm::dvec2 at) const = 0;  // pixels of this widget
  virtual glm::dvec2 placeAt(QPointF position) const = 0;
  virtual QString addTip() const = 0;

 Q_SIGNALS:
  void changed(bool endsAfterPause);
  void dragStarted();
  void dragEnded();
  void selectionChanged();

 protected:
  // Returns the nearest place that this point may have; a new one has the index points().size().
  virtual glm::dvec2 reachable(glm::dvec2 at, std::size_t index) const = 0;
  virtual std::size_t indexOfNew(glm::dvec2) const { return points_.size(); }
  virtual glm::dvec3 colorAt(glm::dvec2 at) const = 0;
  virtual QImage pictureOf(const std::vector<MapPoint>& points) const = 0;
  virtual QRectF area() const = 0;                  // of the picture
  virtual void paintOver(QPainter& painter) const;  // between picture and points
  int pointAt(QPointF position) const;              // -1: none
  void beginDrag(QPointF grip);                     // of the selected point, so far from the pointer

  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

  static constexpr double radius = 6.0;  // of a point, pixels

 private:
  const std::vector<Axis> axes_;
  const std::size_t fewest_;
  std::vector<MapPoint> points_;
  QImage map_;
  int selected_ = 0;
  bool pressed_ = false;
  QPointF grip_;  // from the pointer to the point it drags, pixels
};

class PointsEditor : public ValueWidget {
  Q_OBJECT
 public:
  PointsEditor(PointsView* view, QWidget* parent);
  void showValue(const nlohmann::json& value) override;
  nlohmann::json value() const override;

  PointsView* view() const { return view_; }
  QToolButton* removeButton() const { return remove_; }

 private:
  void showSelected();
  void moveSelected();

  PointsView* view_;
  ColorButton* colour_;
  std::vector<NumberSpinBox*> places_;  // one for each axis
  QToolButton *add_, *remove_;
};

}  // namespace isolux::ui
