// The isovalue as a line on the histogram: drag it, nudge it with wheel or arrow keys, type it beside.
//
// Counts are logarithmic. Ctrl+wheel zooms the value axis, middle drag pans it; a double click asks for the
// suggested isovalue. Sends at most one value per turn of the event loop while it is dragged.
#pragma once

#include <memory>
#include <optional>

#include <QTimer>
#include <QWidget>

#include "app/interaction/histogram_plot.h"
#include "ui/document/document.h"

namespace isolux::ui {

class HistogramSlider : public QWidget {
  Q_OBJECT
 public:
  explicit HistogramSlider(QWidget* parent = nullptr);
  ~HistogramSlider() override;

  void setVolume(VolumePointer volume);
  void setIsovalue(double value, bool insideAbove);
  void showAll();
  void zoomAtLine(double factor);

  const app::HistogramPlot& plot() const { return plot_; }
  double isovalue() const { return isovalue_; }
  // Widget coordinates of the isovalue's line at half the plot's height.
  QPointF linePosition() const;
  QPointF positionOf(double value) const;

 Q_SIGNALS:
  void dragStarted();
  void dragEnded();
  void isovalueChanged(double value, bool endsAfterPause);
  void suggestionWanted();
  void zoomChanged(bool zoomed);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  QSize sizeHint() const override { return {600, 130}; }
  QSize minimumSizeHint() const override { return {220, 96}; }

 private:
  struct DetailJob;
  QRectF plotArea() const;
  void moveTo(double value);  // while dragged: sent with the next turn of the event loop
  void nudge(double steps);   // wheel and keys
  void sendPending();
  void endDrag();
  void endPan();
  void zoomed();
  void stopDetail();
  void wantDetail();  // a finer histogram, counted on another thread
  void paintColumns(QPainter& painter, const QRectF& area) const;
  void paintAxis(QPainter& painter, const QRectF& area) const;
  void paintLine(QPainter& painter, const QRectF& area) const;
  QString text(double value) const;

  VolumePointer volume_;
  app::HistogramPlot plot_;
  volume::Histogram detail_;  // finer than the volume's own; empty until somebody zooms in
  std::shared_ptr<DetailJob> detailJob_;
  QTimer detailTimer_, sendTimer_;
  double isovalue_ = 0.0;
  bool insideAbove_ = true;
  std::optional<double> pending_, hovered_;
  bool dragging_ = false, panning_ = false;
  double grabOffset_ = 0.0;  // pixels from the pointer to the line
  double panPixel_ = 0.0;
};

}  // namespace isolux::ui
