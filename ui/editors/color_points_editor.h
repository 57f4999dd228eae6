// Edits a one-dimensional transfer function (look.colormap_points, look.accessibility_points): a colour bar
// with its control points on it.
//
// A click on the bar adds a point, a drag moves it between its neighbours. Keys: Tab to the next point,
// arrows move by hundredths, Insert or Enter adds one behind the selected point, Delete removes it. Two
// always stay.
#pragma once

#include <vector>

#include <QImage>

#include "ui/editors/setting_editor.h"

class QToolButton;

namespace isolux::ui {

class ColorButton;
class NumberSpinBox;

// The bar itself.
class ColorPointsView : public QWidget {
  Q_OBJECT
 public:
  explicit ColorPointsView(QWidget* parent);

  void showPoints(const std::vector<scene::ColorPoint>& points);  // ascending, at least two
  const std::vector<scene::ColorPoint>& points() const { return points_; }
  int selected() const { return selected_; }  // an index into points()
  const scene::ColorPoint& selectedPoint() const { return points_[static_cast<std::size_t>(selected_)]; }
  void select(int index);

  void addPoint(double position);  // in the colour of the bar there; selects it
  void addBehindSelected();        // halfway to the next point, of the last one to the point before
  void removeSelected();
  // Moves it no farther than to its neighbours.
  void replaceSelected(scene::ColorPoint point, bool endsAfterPause);

  QPointF placeOf(double position) const;  // pixels of this widget
  double positionAt(QPointF place) const;  // clamped to 0 .. 1

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
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  bool focusNextPrevChild(bool next) override;

 private:
  QRectF bar() const;
  int pointAt(QPointF place) const;  // -1: none

  std::vector<scene::ColorPoint> points_;
  QImage colours_;
  int selected_ = 0;
  bool pressed_ = false;
};

class ColorPointsEditor : public ValueWidget {
  Q_OBJECT
 public:
  ColorPointsEditor(const scene::SettingInfo& setting, QWidget* parent);
  void showValue(const nlohmann::json& value) override;
  nlohmann::json value() const override;

  ColorPointsView* view() const { return view_; }
  ColorButton* colourButton() const { return colour_; }
  QToolButton* removeButton() const { return remove_; }

 private:
  void showSelected();

  ColorPointsView* view_;
  ColorButton* colour_;
  NumberSpinBox* position_;
  QToolButton *add_, *remove_;
};

}  // namespace isolux::ui
