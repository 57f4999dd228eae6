#include "base/quantiles.h"

#include <vector>

#include <gtest/gtest.h>

namespace isolux::base {
namespace {

TEST(Quantiles, MedianIsTheMiddleOrHalfWayBetweenTheMiddleTwo) {
  std::vector<double> one{4.0}, odd{9.0, 1.0, 5.0}, even{8.0, 1.0, 3.0, 2.0};
  EXPECT_EQ(median(one), 4.0);
  EXPECT_EQ(median(odd), 5.0);
  EXPECT_EQ(median(even), 2.5);
}

TEST(Quantiles, EndsAreTheLeastAndTheGreatest) {
  std::vector<double> values{3.0, -1.0, 7.0, 2.0};
  for (const auto of : {quantile, lowerQuantile, upperQuantile}) {
    EXPECT_EQ(of(values, 0.0), -1.0);
    EXPECT_EQ(of(values, 1.0), 7.0);
  }
}

TEST(Quantiles, BetweenTwoValuesTheNearerTheLowerOrTheUpperOneCounts) {
  std::vector<double> values;
  for (int i = 10; i >= 0; --i) values.push_back(i);
  EXPECT_EQ(quantile(values, 0.54), 5.0);
  EXPECT_EQ(quantile(values, 0.56), 6.0);
  EXPECT_EQ(lowerQuantile(values, 0.56), 5.0);
  EXPECT_EQ(upperQuantile(values, 0.54), 6.0);
  std::vector<double> even{1.0, 2.0, 3.0, 4.0};
  EXPECT_EQ(quantile(even, 0.5), 3.0) << "of two that are equally near the upper one";
  EXPECT_EQ(lowerQuantile(even, 0.5), 2.0);
  EXPECT_EQ(upperQuantile(even, 0.5), 3.0);
}

}  // namespace
}  // namespace isolux::base
