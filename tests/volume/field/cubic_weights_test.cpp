#include "volume/field/cubic_weights.h"

#include <cmath>

#include <gtest/gtest.h>

namespace isolux::volume {
namespace {

TEST(CubicWeights, ArePartitionOfUnityWithVanishingDerivativeSums) {
  for (double t = 0.0; t <= 1.0; t += 1.0 / 64) {
    const CubicWeights c = cubicWeights(t);
    double w = 0, d1 = 0, d2 = 0, first = 0;
    for (int k = 0; k < 4; ++k) {
      EXPECT_GE(c.w[k], 0.0);
      w += c.w[k];
      d1 += c.d1[k];
      d2 += c.d2[k];
      first += c.w[k] * (k - 1);
    }
    EXPECT_NEAR(w, 1.0, 1e-15);
    EXPECT_NEAR(d1, 0.0, 1e-15);
    EXPECT_NEAR(d2, 0.0, 1e-15);
    EXPECT_NEAR(first, t, 1e-15);  // linear fields are reproduced
  }
}

TEST(CubicWeights, DerivativesAreThoseOfTheWeights) {
  for (double t = 0.05; t < 1.0; t += 0.1) {
    const CubicWeights c = cubicWeights(t), a = cubicWeights(t - 1e-5), b = cubicWeights(t + 1e-5);
    for (int k = 0; k < 4; ++k) {
      EXPECT_NEAR(c.d1[k], (b.w[k] - a.w[k]) / 2e-5, 1e-9);
      EXPECT_NEAR(c.d2[k], (b.d1[k] - a.d1[k]) / 2e-5, 1e-9);
    }
  }
}

TEST(CubicWeights, InSinglePrecisionAreTheSameToItsLastDigits) {
  for (int i = 0; i <= 64; ++i) {
    const CubicWeights exact = cubicWeights(i / 64.0);
    const CubicWeights single = cubicWeights(static_cast<float>(i) / 64.0f);
    for (int k = 0; k < 4; ++k) {
      EXPECT_FLOAT_EQ(single.w[k], static_cast<float>(exact.w[k]));
      EXPECT_FLOAT_EQ(single.d1[k], static_cast<float>(exact.d1[k]));
      EXPECT_FLOAT_EQ(single.d2[k], static_cast<float>(exact.d2[k]));
    }
  }
}

}  // namespace
}  // namespace isolux::volume
