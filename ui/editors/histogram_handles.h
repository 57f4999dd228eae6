// The lines of isosurfaces on the histogram: one for each, in its colour, with its value or its name.
#pragma once

#include <vector>

#include <QColor>
#include <QFont>
#include <QRectF>
#include <QString>

class QPainter;

namespace isolux::ui {

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

// `area`: the plot; labels stand above it, within [1, width - 1]. A label that would cover that of a handle
// painted later is only a mark.
void paintHandles(QPainter& painter, const QRectF& area, double width, const QFont& font,
                  std::vector<PlacedHandle> handles);

// The one whose line is within `reach` pixels of x, the nearest; null: none.
const PlacedHandle* handleAt(const std::vector<PlacedHandle>& handles, double x, double reach);

}  // namespace isolux::ui
