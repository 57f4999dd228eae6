#include "base/number_text.h"

#include <cmath>
#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>

namespace isolux::base {
namespace {

TEST(NumberText, ShortOneHasSixDigitsAtMostAndNoTrailingZeros) {
  EXPECT_EQ(shortText(300.0), "300");
  EXPECT_EQ(shortText(-0.25), "-0.25");
  EXPECT_EQ(shortText(1.0 / 3.0), "0.333333");
  EXPECT_EQ(shortText(1234567.0), "1.23457e+06");
  EXPECT_EQ(shortText(99.7, 2), "100");
  EXPECT_EQ(shortText(-1234.0, 2), "-1200");
  EXPECT_EQ(shortText(1.0 / 3.0, 2), "0.33");
  EXPECT_EQ(shortText(0.1, 17), "0.10000000000000001");
  EXPECT_EQ(shortText(0.1, 100), "0.10000000000000001") << "no double has more digits";
  EXPECT_EQ(shortText(std::numeric_limits<double>::infinity()), "inf");
}

TEST(NumberText, ShortestOneHasNoDigitTooMany) {
  EXPECT_EQ(shortestText(0.1), "0.1");
  EXPECT_EQ(shortestText(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(shortestText(1e300), "1e+300");
}

TEST(NumberText, ExactOneReadsBackAndIsBriefWhereItCan) {
  EXPECT_EQ(exactText(0.1), "0.1");
  EXPECT_EQ(exactText(0.1234567), "0.1234567");
  EXPECT_EQ(exactText(1.0 / 3.0), "0.33333333333333331");
  for (const double value : {0.7, 1e-320, -1.7976931348623157e308, 5.20833333333333333, M_PI})
    for (const std::string& text : {exactText(value), shortestText(value)})
      EXPECT_EQ(std::strtod(text.c_str(), nullptr), value) << text;
}

TEST(NumberText, HexadecimalOneHasAllItsZeros) {
  EXPECT_EQ(hexText(0), "0000000000000000");
  EXPECT_EQ(hexText(0x1234abcdull), "000000001234abcd");
  EXPECT_EQ(hexText(~0ull), "ffffffffffffffff");
}

}  // namespace
}  // namespace isolux::base
