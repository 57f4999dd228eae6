#include "volume/hit/bernstein_cubic.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/rays.h"

namespace isolux::volume {
namespace {

CellCorners randomCorners(std::uint64_t i) {
  CellCorners corners;
  for (std::size_t c = 0; c < 8; ++c) corners[c] = test::randomVector(i, c).x - 0.5;
  return corners;
}

TEST(BernsteinCubic, IsTheFieldAlongTheStretch) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    const CellCorners corners = randomCorners(i);
    const glm::dvec3 from = test::randomVector(i, 8), to = test::randomVector(i, 9);
    const BernsteinCubic cubic = BernsteinCubic::along(corners, from, to);
    EXPECT_EQ(cubic(0.0), trilinear(corners, from));
    EXPECT_EQ(cubic(1.0), trilinear(corners, to));
    for (const double s : {0.125, 0.3, 0.5, 0.9})
      EXPECT_NEAR(cubic(s), trilinear(corners, from + s * (to - from)), 1e-15) << i << ' ' << s;
  }
}

TEST(BernsteinCubic, CornersAreExact) {
  const CellCorners corners{1.1, -2.3, 1e-9, 4.7, 1e9, 0.3, -0.1, 7.0};
  for (std::size_t c = 0; c < 8; ++c)
    EXPECT_EQ(trilinear(corners, glm::dvec3(c & 1, c >> 1 & 1, c >> 2)), corners[c]);
}

TEST(BernsteinCubic, ExtremaAreThoseOfKnownPolynomials) {
  std::array<double, 2> s{};
  // (s - 1/4)(s - 3/4) integrated: s^3 / 3 - s^2 / 2 + 3 s / 16.
  const double third = 1.0 / 3.0;
  ASSERT_EQ((BernsteinCubic{{0.0, 0.0625, -1.0 / 6.0 + 0.125, third - 0.5 + 0.1875}}.extrema(s)), 2);
  EXPECT_NEAR(s[0], 0.25, 1e-15);
  EXPECT_NEAR(s[1], 0.75, 1e-15);
  ASSERT_EQ((BernsteinCubic{{0.0, 1.0, 1.0, 0.0}}.extrema(s)), 1) << "a parabola";
  EXPECT_EQ(s[0], 0.5);
  EXPECT_EQ((BernsteinCubic{{0.0, 1.0, 2.0, 3.0}}.extrema(s)), 0) << "a line";
  EXPECT_EQ((BernsteinCubic{{5.0, 5.0, 5.0, 5.0}}.extrema(s)), 0) << "a constant";
  EXPECT_EQ((BernsteinCubic{{0.0, 0.0, 1.0, 1.0}}.extrema(s)), 0) << "extrema at the ends are none";
}

TEST(BernsteinCubic, IsMonotoneBetweenItsExtrema) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    const glm::dvec3 low = test::randomVector(i, 1) - 0.5, high = test::randomVector(i, 2) - 0.5;
    const BernsteinCubic cubic{{low.x, low.y, high.x, high.y}};
    std::array<double, 2> s{};
    const int count = cubic.extrema(s);
    double begin = 0.0;
    for (int piece = 0; piece <= count; ++piece) {
      const double end = piece < count ? s[static_cast<std::size_t>(piece)] : 1.0;
      const double rise = cubic(end) - cubic(begin);
      for (int k = 1; k <= 16; ++k) {
        const double a = begin + (end - begin) * (k - 1) / 16.0, b = begin + (end - begin) * k / 16.0;
        EXPECT_GE((cubic(b) - cubic(a)) * std::copysign(1.0, rise), -1e-15) << i << ' ' << piece;
      }
      begin = end;
    }
  }
}

}  // namespace
}  // namespace isolux::volume
