// Isovalues as lines on the histogram: drag them, nudge them with wheel or arrow keys, type them beside.
//
// Counts are logarithmic. Ctrl+wheel zooms the value axis, middle drag pans it; a double click asks for the
// suggested isovalue, Alt+click or the menu of a right click for one more isosurface. Of several lines the
// one that was taken hold of last is moved by keys, the wheel, and clicks beside lines. Sends at most one
// value per turn of the event loop while it is dragged.
#pragma once

#include <optional>
#include <vector>

#include <QColor>
#include <QString>
#include <QTimer>
#include <QWidget>

#include "app/view_math/histogram_plot.h"
#include "ui/document/background_task.h"
#include "ui/document/document.h"

namespace isolux::ui {

// The line of an isosurface.
struct HistogramHandle {
  int number = 0;  // app::ListedSurface
  double value = 0.0;
  QColor colour;
  QString name;
  bool shown = true;
};

// A handle where it is painted.
struct PlacedHandle {
  const HistogramHandle* handle = nullptr;
  double x = 0.0;  // widget coordinates; beyond `area` where the axis does not show its value
  QString label;
  bool active = false;  // moved by keys and by clicks beside the lines; its label is on top
};

class HistogramSlider : public QWidget {
  Q_OBJECT
 public:
  explicit HistogramSlider(QWidget* parent = nullptr);

  void setVolume(VolumePointer volume);
  // Of the first isosurface.
  void setIsovalue(double value, bool insideAbove);
  // All that have a line, the first among them; fewer than two: it has the only one.
  void setSurfaces(const std::vector<HistogramHandle>& surfaces);
  void showAll();
  void zoomAtLine(double factor);

  const app::HistogramPlot& plot() const { return plot_; }
  double isovalue() const { return isovalue_; }
  // Widget coordinates of an isosurface's line at half the plot's height; 0: of the first.
  QPointF linePosition(int number = 0) const { return positionOf(valueOf(number)); }
  int active() const { return active_; }
  QPointF positionOf(double value) const;

 Q_SIGNALS:
  void dragStarted();
  void dragEnded();
  void isovalueChanged(double value, bool endsAfterPause);
  void surfaceMoved(int number, double value, bool endsAfterPause);  // a further isosurface
  void surfaceWanted(double value);                                  // one more
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
  void contextMenuEvent(QContextMenuEvent* event) override;
  bool event(QEvent* event) override;
  QSize sizeHint() const override { return {600, 130}; }
  QSize minimumSizeHint() const override { return {220, 96}; }

 private:
  QRectF plotArea() const;
  void moveTo(double value);         // while dragged: sent with the next turn of the event loop
  void nudge(double steps);          // wheel and keys
  double valueOf(int number) const;  // of that isosurface
  void setActiveValue(double value);
  void emitActive(double value, bool endsAfterPause);
  double valueUnder(double x) const;
  std::vector<PlacedHandle> placedHandles() const;
  void sendPending();
  void endDrag();
  void endPan();
  void zoomed();
  void wantDetail();  // a finer histogram, counted on another thread
  void paintColumns(QPainter& painter, const QRectF& area) const;
  void paintAxis(QPainter& painter, const QRectF& area) const;
  QString text(double value) const;

  VolumePointer volume_;
  app::HistogramPlot plot_;
  volume::Histogram detail_;  // finer than the volume's own; empty until somebody zooms in
  BackgroundTask<volume::Histogram> detailTask_;
  QTimer sendTimer_;
  double isovalue_ = 0.0;
  std::vector<HistogramHandle> handles_;  // all; never empty
  int active_ = 0;
  bool insideAbove_ = true;
  std::optional<double> pending_, hovered_;
  bool dragging_ = false, panning_ = false;
  double grabOffset_ = 0.0;  // pixels from the pointer to the line
  double panPixel_ = 0.0;
};

}  // namespace isolux::ui
