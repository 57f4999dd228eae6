// What bounds of light are made of: tolerance limits and smoothing, against simulation and formulas.
#include "app/accuracy/light_bounds.h"

#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "base/random.h"

namespace isolux::app {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

// Scores whose distribution is known: with p uniform, those below the limit are the share 1 - exp(-limit) of
// all.
TEST(ToleranceLimit, HoldsInAsManyDrawsAsItSaysAndIsNoLargerThanItNeedsBe) {
  for (const std::size_t n : {std::size_t{90}, std::size_t{200}, kTracedPixels}) {
    int held = 0;
    double share = 0.0;
    constexpr int draws = 2000;
    for (int draw = 0; draw < draws; ++draw) {
      std::vector<double> scores;
      for (std::size_t i = 0; i < n; ++i)
        scores.push_back(-std::log1p(-base::uniformNoise(static_cast<std::uint64_t>(draw) + 10000 * n, i)));
      const double within = 1.0 - std::exp(-toleranceLimit(scores, false));
      held += within >= kLightLevel;
      share += within / draws;
    }
    EXPECT_GE(held, draws * (kLightConfidence - 0.007)) << n;
    EXPECT_LE(share, n >= 500 ? 0.977 : 0.995) << n;
  }
}

TEST(ToleranceLimit, TooFewSayNothingAndAllSayAll) {
  std::vector<double> scores(89);
  std::iota(scores.begin(), scores.end(), 1.0);
  EXPECT_EQ(toleranceLimit(scores, false), kNone);  // 0.95^89 is above 1 %
  EXPECT_EQ(toleranceLimit(scores, true), 85.0);    // 85 of 89
  scores.push_back(90.0);
  EXPECT_EQ(toleranceLimit(scores, false), 90.0);  // 0.95^90 is not
  std::vector<double> none;
  EXPECT_EQ(toleranceLimit(none, true), kNone);
}

TEST(SmoothedRoots, OfEvenSquaresAreTheirRootsWhateverIsMissing) {
  std::vector<float> squares(20 * 12, 4.0f);
  for (std::size_t i = 0; i < squares.size(); i += 7) squares[i] = std::nanf("");
  const std::vector<float> roots = smoothedRoots(squares, 20, 3);
  for (std::size_t i = 0; i < squares.size(); ++i) {
    EXPECT_EQ(std::isnan(roots[i]), std::isnan(squares[i]));
    if (std::isnan(roots[i])) continue;
    EXPECT_NEAR(roots[i], 2.0f * std::sqrt(1.04f), 1e-5f);
  }
}

TEST(SmoothedRoots, OfNothingAreTheSameEverywhere) {
  const std::vector<float> squares(30, 0.0f);
  for (const float root : smoothedRoots(squares, 6, 2)) EXPECT_EQ(root, 1.0f);
}

TEST(SmoothedRoots, ASquareIsSpreadOverItsNeighbours) {
  std::vector<float> squares(41 * 41, 0.0f);
  squares[20 * 41 + 20] = 1.0f;
  const std::vector<float> roots = smoothedRoots(squares, 41, 2);
  const double least = 0.04 / (41.0 * 41.0);  // everywhere
  double sum = 0.0, spread = 0.0;
  for (int y = 0; y < 41; ++y)
    for (int x = 0; x < 41; ++x) {
      const double root = static_cast<double>(roots[static_cast<std::size_t>(y * 41 + x)]);
      const double part = root * root - least;
      sum += part;
      spread += part * (x - 20) * (x - 20);
      if (std::abs(x - 20) > 6 || std::abs(y - 20) > 6) {
        EXPECT_NEAR(part, 0.0, 1e-7);
      }
    }
  EXPECT_NEAR(sum, 1.0, 1e-3);
  EXPECT_NEAR(spread, 3.0 * 2.0, 1e-2);  // three boxes of 5: variance (25 - 1) / 12 each
}

}  // namespace
}  // namespace isolux::app
