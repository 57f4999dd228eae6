#include "volume/statistics/grey_window.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace isolux::volume {
namespace {

TEST(GreyWindow, ReachesFromTheFirstToTheLastPercentile) {
  Histogram even{0.0, 100.0, std::vector<std::uint64_t>(50, 7), {}};
  const GreyWindow window = greyWindow(even);
  EXPECT_NEAR(window.level, 50.0, 1e-12);
  EXPECT_NEAR(window.width, 98.0, 1e-12);
  // One voxel of metal far above does not darken the rest.
  Histogram metal{0.0, 3000.0, std::vector<std::uint64_t>(3000, 0), {}};
  for (std::size_t bin = 0; bin < 1000; ++bin) metal.counts[bin] = 100;
  metal.counts[2999] = 1;
  EXPECT_NEAR(greyWindow(metal).level, 500.0, 0.1);
  EXPECT_NEAR(greyWindow(metal).width, 980.0, 0.1);
}

TEST(GreyWindow, IsTheWholeRangeWhereNearlyAllIsOneValue) {
  Histogram empty{-10.0, 30.0, std::vector<std::uint64_t>(40, 0), {}};
  empty.counts[5] = 100000;
  empty.counts[39] = 10;
  EXPECT_EQ(greyWindow(empty), (GreyWindow{10.0, 40.0}));
  EXPECT_EQ(greyWindow(Histogram{7.0, 7.0, {12}, {}}), (GreyWindow{7.0, 1.0}));
  EXPECT_EQ(greyWindow(Histogram{}), (GreyWindow{0.0, 1.0}));
}

TEST(GreyWindow, KeepsWhatTheSceneSays) {
  const Histogram even{0.0, 100.0, std::vector<std::uint64_t>(100, 1), {}};
  scene::Slice slice;
  EXPECT_EQ(greyWindow(slice, even), greyWindow(even));
  slice.level = -20.0;
  EXPECT_EQ(greyWindow(slice, even).level, -20.0);
  EXPECT_EQ(greyWindow(slice, even).width, greyWindow(even).width);
  slice.width = 0.0;
  EXPECT_EQ(greyWindow(slice, even), (GreyWindow{-20.0, 0.0}));
}

TEST(GreyWindow, GreyGrowsEvenlyBetweenBlackAndWhite) {
  const GreyWindow window{40.0, 400.0};
  EXPECT_EQ(window.greyOf(-161.0), 0.0);
  EXPECT_EQ(window.greyOf(40.0), 0.5);
  EXPECT_EQ(window.greyOf(140.0), 0.75);
  EXPECT_EQ(window.greyOf(1e30), 1.0);
  EXPECT_TRUE(std::isnan(window.greyOf(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_EQ((GreyWindow{3.0, 0.0}.greyOf(2.9)), 0.0);
  EXPECT_EQ((GreyWindow{3.0, 0.0}.greyOf(3.0)), 1.0);
}

}  // namespace
}  // namespace isolux::volume
