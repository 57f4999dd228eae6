#include "base/decimal_text.h"

#include <limits>

#include <gtest/gtest.h>

namespace isolux::base {
namespace {

TEST(DecimalText, HasSoManyDecimals) {
  EXPECT_EQ(fixedText(0.5, 2), "0.50");
  EXPECT_EQ(fixedText(-12.345, 1), "-12.3");
  EXPECT_EQ(fixedText(2.5, 0), "2");
  EXPECT_EQ(fixedText(std::numeric_limits<double>::max(), 20).size(), 330u);
}

TEST(DecimalText, ANumberIsAllOfAText) {
  EXPECT_EQ(readNumber("0.5"), 0.5);
  EXPECT_EQ(readNumber("+1e3"), 1000.0);
  EXPECT_EQ(readNumber("-2"), -2.0);
  for (const char* text : {"", "+", "+-1", "1,5", "3mm", " 1", "nan", "inf", "1e999"})
    EXPECT_FALSE(readNumber(text)) << text;
}

}  // namespace
}  // namespace isolux::base
