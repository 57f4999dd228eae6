#include "base/numbers.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace isolux::base {
namespace {

TEST(Numbers, NiceOnesAboveAreNotBelow) {
  EXPECT_EQ(niceAbove(7.3), 10.0);
  EXPECT_EQ(niceAbove(2.0), 2.0);
  EXPECT_EQ(niceAbove(2.01), 5.0);
  EXPECT_DOUBLE_EQ(niceAbove(0.0019), 0.002);
  EXPECT_DOUBLE_EQ(niceAbove(8e300), 1e301);
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_EQ(niceAbove(bad), 1.0);
}

TEST(Numbers, NiceOnesAreOneTwoFiveTimesAPowerOfTen) {
  EXPECT_EQ(niceBelow(7.3), 5.0);
  EXPECT_EQ(niceBelow(2.0), 2.0);
  EXPECT_EQ(niceBelow(1.99), 1.0);
  EXPECT_DOUBLE_EQ(niceBelow(0.0021), 0.002);
  EXPECT_DOUBLE_EQ(niceBelow(8e300), 5e300);
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_EQ(niceBelow(bad), 1.0);
}

TEST(Numbers, RoundedOnesAreTheNearestDecimals) {
  EXPECT_EQ(roundedToStep(0.30000000000000004, 0.1), 0.3);
  EXPECT_EQ(roundedToStep(1234.4, 5.0), 1235.0);
  EXPECT_EQ(roundedToStep(-0.26, 0.05), -0.25);
  EXPECT_DOUBLE_EQ(roundedToStep(1.7e308, 1e300), 1.7e308);
  EXPECT_EQ(roundedToStep(3.14, 0.0), 3.14) << "no step: as it is";
  EXPECT_TRUE(std::isnan(roundedToStep(std::nan(""), 0.1)));
}

}  // namespace
}  // namespace isolux::base
