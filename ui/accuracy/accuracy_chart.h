// Error against cost of the values of one quality setting, each a point to click; the values worth their cost
// are joined by a line.
//
// Marks differ by shape, not only by colour: a filled square is the present setting, a ring the default.
#pragma once

#include <optional>
#include <vector>

#include <QChartView>

#include "app/study/quality_points.h"

class QGraphicsSimpleTextItem;

namespace isolux::ui {

class AccuracyChart : public QChartView {
  Q_OBJECT
 public:
  explicit AccuracyChart(QWidget* parent = nullptr);

  // `costLabel`, `errorLabel`: with units.
  void show(std::vector<app::QualityPoint> points, const QString& costLabel, const QString& errorLabel);
  const std::vector<app::QualityPoint>& points() const { return points_; }
  QPointF placeOf(std::size_t point) const;  // pixels of the widget

 Q_SIGNALS:
  void chosen(const QString& value);

 protected:
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void rebuild();
  void placeLabels();
  // Cost, and the decimal logarithm of the error; one of 0 stands at the axis's lower end.
  QPointF inAxes(const app::QualityPoint& point) const;
  std::optional<std::size_t> pointAt(QPointF place) const;

  std::vector<app::QualityPoint> points_;
  QString costLabel_, errorLabel_;
  double least_ = 1e-6;  // of the error's axis
  QList<QGraphicsSimpleTextItem*> labels_;
};

}  // namespace isolux::ui
