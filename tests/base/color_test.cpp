#include "base/color.h"

#include <gtest/gtest.h>

namespace isolux::base {
namespace {

struct Rgb {
  double x, y, z;
};
struct RgbFloat {
  float x, y, z;
};

TEST(Color, LuminanceOfWhiteIsOneAndOfThePrimariesThatOfBt709) {
  EXPECT_DOUBLE_EQ(luminance(Rgb{1.0, 1.0, 1.0}), 1.0);
  EXPECT_EQ(luminance(Rgb{1.0, 0.0, 0.0}), 0.2126);
  EXPECT_EQ(luminance(Rgb{0.0, 1.0, 0.0}), 0.7152);
  EXPECT_EQ(luminance(Rgb{0.0, 0.0, 1.0}), 0.0722);
}

TEST(Color, KeepsThePrecisionItIsGiven) {
  static_assert(std::is_same_v<decltype(luminance(RgbFloat{})), float>);
  EXPECT_EQ(luminance(RgbFloat{0.3f, 0.5f, 0.7f}), 0.2126f * 0.3f + 0.7152f * 0.5f + 0.0722f * 0.7f);
  EXPECT_EQ(decodeSrgb(0.03f), 0.03f / 12.92f);
  EXPECT_EQ(decodeSrgb(0.6f), std::pow((0.6f + 0.055f) / 1.055f, 2.4f));
}

TEST(Color, SrgbInvertsItself) {
  for (int i = 0; i <= 255; ++i) EXPECT_NEAR(encodeSrgb(decodeSrgb(i / 255.0)), i / 255.0, 1e-5);
  EXPECT_NEAR(decodeSrgb(0.5), 0.21404, 1e-5);
}

TEST(Color, BytesOfAScreenGoBackToThemselvesAndAreCutOff) {
  for (int i = 0; i <= 255; ++i) EXPECT_EQ(screenByte(decodeSrgb(i / 255.0)), i);
  EXPECT_EQ(screenByte(-0.5), 0);
  EXPECT_EQ(screenByte(7.0), 255);
}

}  // namespace
}  // namespace isolux::base
