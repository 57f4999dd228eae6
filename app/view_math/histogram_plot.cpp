#include "app/view_math/histogram_plot.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"

namespace isolux::app {

HistogramPlot::HistogramPlot(double minimum, double maximum) : minimum_(minimum), maximum_(maximum) {
  if (!(maximum_ > minimum_)) {  // a constant volume still gets an axis
    const double half = std::max(0.5, 0.01 * std::abs(minimum));
    minimum_ = minimum - half;
    maximum_ = minimum + half;
  }
  showAll();
}

void HistogramPlot::showAll() {
  shownMinimum_ = minimum_;
  shownMaximum_ = maximum_;
}

void HistogramPlot::clampShown(double range) {
  const double whole = maximum_ - minimum_;
  range = std::clamp(range, whole * 1e-5, whole);
  shownMinimum_ = std::clamp(shownMinimum_, minimum_, maximum_ - range);
  shownMaximum_ = range >= whole ? maximum_ : shownMinimum_ + range;
}

void HistogramPlot::zoom(double factor, double anchor) {
  if (!(factor > 0.0) || !std::isfinite(factor)) return;
  const double whole = maximum_ - minimum_;
  const double range = std::clamp(shownRange() / factor, whole * 1e-5, whole);
  const double fraction = std::clamp((anchor - shownMinimum_) / shownRange(), 0.0, 1.0);
  shownMinimum_ = anchor - fraction * range;
  clampShown(range);
}

void HistogramPlot::pan(double values) {
  const double range = shownRange();
  shownMinimum_ += values;
  clampShown(range);
}

void HistogramPlot::reveal(double value) {
  if (value < shownMinimum_) {
    pan(value - shownMinimum_ - 0.1 * shownRange());
  } else if (value > shownMaximum_) {
    pan(value - shownMaximum_ + 0.1 * shownRange());
  }
}

double HistogramPlot::valueAt(double pixel, double width) const {
  return shownMinimum_ + shownRange() * pixel / std::max(1.0, width);
}

double HistogramPlot::pixelOf(double value, double width) const {
  return (value - shownMinimum_) / shownRange() * width;
}

std::vector<float> HistogramPlot::columns(const volume::Histogram& histogram, int width) const {
  std::vector<float> heights(static_cast<std::size_t>(std::max(0, width)), 0.0F);
  const auto bins = static_cast<double>(histogram.counts.size());
  const double range = histogram.maximum - histogram.minimum;
  if (histogram.counts.empty()) return heights;
  float highest = 0.0F;
  for (std::size_t x = 0; x < heights.size(); ++x) {
    const double low = valueAt(static_cast<double>(x), width),
                 high = valueAt(static_cast<double>(x) + 1.0, width);
    // The bins that the pixel touches; a constant volume has one bin without width, at its value.
    double first = 0.0, last = 0.0;
    if (range > 0.0) {
      first = std::floor((low - histogram.minimum) / range * bins);
      last = std::ceil((high - histogram.minimum) / range * bins) - 1.0;
    } else if (histogram.minimum < low || histogram.minimum >= high) {
      continue;
    }
    if (last < 0.0 || first >= bins) continue;
    const auto begin = static_cast<std::size_t>(std::max(0.0, first));
    const auto end = static_cast<std::size_t>(std::min(bins - 1.0, std::max(first, last)));
    std::uint64_t count = 0;
    for (std::size_t bin = begin; bin <= end; ++bin) count = std::max(count, histogram.counts[bin]);
    heights[x] = static_cast<float>(std::log1p(static_cast<double>(count)));
    highest = std::max(highest, heights[x]);
  }
  if (highest > 0.0F) {
    for (float& height : heights) height /= highest;
  }
  return heights;
}

std::vector<double> HistogramPlot::ticks(double width, double spacing) const {
  constexpr double slack = 1.0 - 1e-9;  // a round number stays in spite of rounding
  const double step = base::niceAbove(slack * shownRange() * spacing / std::max(1.0, width));
  std::vector<double> values;
  for (double k = std::ceil(shownMinimum_ / step); k * step <= shownMaximum_ && values.size() < 100;
       k += 1.0) {
    values.push_back(base::roundedToStep(k * step, step));
  }
  return values;
}

double HistogramPlot::fineStep() const {
  return base::niceBelow(shownRange() / 1000.0);
}

}  // namespace isolux::app
