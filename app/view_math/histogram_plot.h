// Where a histogram lies on the screen: which values are shown, which pixel is which value, how high each
// column stands. Plain arithmetic, no Qt. Values in data units, pixels from the plot's left edge.
#pragma once

#include <vector>

#include "volume/statistics/histogram.h"

namespace isolux::app {

class HistogramPlot {
 public:
  HistogramPlot() = default;
  HistogramPlot(double minimum, double maximum);  // the whole range; equal values are widened

  double minimum() const { return minimum_; }
  double maximum() const { return maximum_; }
  double shownMinimum() const { return shownMinimum_; }
  double shownMaximum() const { return shownMaximum_; }
  double shownRange() const { return shownMaximum_ - shownMinimum_; }
  bool zoomed() const { return shownMinimum_ > minimum_ || shownMaximum_ < maximum_; }

  void showAll();
  // factor > 1: closer. `anchor` stays under its pixel. Never beyond the whole range.
  void zoom(double factor, double anchor);
  void pan(double values);
  // Moves the shown range just so far that `value` is in it.
  void reveal(double value);

  double valueAt(double pixel, double width) const;
  double pixelOf(double value, double width) const;
  // log(1 + count) of the fullest bin under each pixel column, scaled so that the highest shown is 1.
  std::vector<float> columns(const volume::Histogram& histogram, int width) const;
  // Multiples of 1, 2 or 5 times a power of ten, `spacing` or more pixels apart.
  std::vector<double> ticks(double width, double spacing) const;
  // A step that is fine on the screen: about a thousandth of what is shown, 1, 2 or 5 times a power of ten.
  double fineStep() const;

 private:
  void clampShown(double range);
  double minimum_ = 0.0, maximum_ = 1.0, shownMinimum_ = 0.0, shownMaximum_ = 1.0;
};

}  // namespace isolux::app
