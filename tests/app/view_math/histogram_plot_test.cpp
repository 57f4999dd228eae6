#include "app/view_math/histogram_plot.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace isolux::app {

TEST(HistogramPlot, PixelsAndValuesAreInverse) {
  HistogramPlot plot(-1000.0, 3000.0);
  plot.zoom(3.7, 120.0);
  for (const double value : {-200.0, 0.0, 500.0}) {
    EXPECT_NEAR(plot.valueAt(plot.pixelOf(value, 640.0), 640.0), value, 1e-9);
  }
}

TEST(HistogramPlot, ZoomKeepsTheAnchorAndStaysInside) {
  HistogramPlot plot(0.0, 100.0);
  const double pixel = plot.pixelOf(30.0, 500.0);
  plot.zoom(8.0, 30.0);
  EXPECT_NEAR(plot.pixelOf(30.0, 500.0), pixel, 1e-9);
  EXPECT_NEAR(plot.shownRange(), 12.5, 1e-9);
  plot.pan(1e9);
  EXPECT_DOUBLE_EQ(plot.shownMaximum(), 100.0);
  plot.reveal(3.0);
  EXPECT_LE(plot.shownMinimum(), 3.0);
  plot.zoom(1e-9, 50.0);
  EXPECT_FALSE(plot.zoomed());
  plot.zoom(std::nan(""), 50.0);
  EXPECT_FALSE(plot.zoomed());
}

TEST(HistogramPlot, ColumnsAreLogarithmicAndShowThinPeaks) {
  volume::Histogram histogram;
  histogram.minimum = 0.0;
  histogram.maximum = 1000.0;
  histogram.counts.assign(1000, 0);
  histogram.counts[500] = 999;  // one bin of a thousand must be seen on 100 pixels
  histogram.counts[100] = 9;
  const auto columns = HistogramPlot(0.0, 1000.0).columns(histogram, 100);
  EXPECT_FLOAT_EQ(columns[50], 1.0F);
  EXPECT_NEAR(columns[10], std::log(10.0) / std::log(1000.0), 1e-6);
  EXPECT_FLOAT_EQ(columns[11], 0.0F);
}

TEST(HistogramPlot, AConstantVolumeHasAnAxis) {
  volume::Histogram histogram;
  histogram.minimum = histogram.maximum = 7.0;
  histogram.counts = {64};
  const HistogramPlot plot(7.0, 7.0);
  EXPECT_GT(plot.shownRange(), 0.0);
  const auto columns = plot.columns(histogram, 50);
  EXPECT_EQ(std::count(columns.begin(), columns.end(), 1.0F), 1);
}

TEST(HistogramPlot, TicksAreRoundNumbersApart) {
  const HistogramPlot plot(-1024.0, 2986.0);
  const auto ticks = plot.ticks(700.0, 85.0);
  ASSERT_GE(ticks.size(), 4U);
  EXPECT_EQ(ticks[0], -1000.0);
  EXPECT_EQ(ticks[1], -500.0);
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    EXPECT_GE(plot.pixelOf(ticks[i], 700.0) - plot.pixelOf(ticks[i - 1], 700.0), 85.0 - 1e-6);
  }
}

}  // namespace isolux::app
