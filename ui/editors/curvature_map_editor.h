// Edits the colour map over (kappa1, kappa2): a picture of the map with its control points on it.
//
// Drag a point, double click to add one, Delete removes the selected one (one always stays), arrow keys move
// it by fiftieths of the range. Kappas are in parts of the map's range. As kappa1 >= kappa2, points are kept
// on and below the diagonal; the half above it is hatched.
#pragma once

#include <vector>

#include <QImage>

#include <glm/vec2.hpp>

#include "ui/editors/setting_editor.h"

class QToolButton;

namespace isolux::ui {

class ColorButton;
class NumberSpinBox;

// The square itself.
class CurvatureMapView : public QWidget {
  Q_OBJECT
 public:
  explicit CurvatureMapView(QWidget* parent);

  void showPoints(const std::vector<scene::CurvaturePoint>& points);
  const std::vector<scene::CurvaturePoint>& points() const { return points_; }
  int selected() const { return selected_; }  // an index into points()
  void select(int index);

  void addPoint(glm::dvec2 kappa);  // in the colour that the map has there; selects it
  void removeSelected();
  void replaceSelected(scene::CurvaturePoint point, bool endsAfterPause);

  QPointF positionOf(glm::dvec2 kappa) const;  // pixels of this widget
  glm::dvec2 kappaAt(QPointF position) const;  // not clamped

 Q_SIGNALS:
  void changed(bool endsAfterPause);
  void dragStarted();
  void dragEnded();
  void selectionChanged();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QRectF square() const;
  int pointAt(QPointF position) const;  // -1: none
  void paintAxes(QPainter& painter) const;
  void paintPoints(QPainter& painter) const;

  std::vector<scene::CurvaturePoint> points_;
  QImage map_;
  int selected_ = 0;
  bool pressed_ = false;
  QPointF grip_;  // from the pointer to the point it drags, pixels
};

class CurvatureMapEditor : public ValueWidget {
  Q_OBJECT
 public:
  explicit CurvatureMapEditor(QWidget* parent);
  void showValue(const nlohmann::json& value) override;
  nlohmann::json value() const override;

  CurvatureMapView* view() const { return view_; }
  ColorButton* colourButton() const { return colour_; }
  QToolButton* removeButton() const { return remove_; }

 private:
  void showSelected();
  void moveSelected();

  CurvatureMapView* view_;
  ColorButton* colour_;
  NumberSpinBox *kappa1_, *kappa2_;
  QToolButton *add_, *remove_;
};

}  // namespace isolux::ui
