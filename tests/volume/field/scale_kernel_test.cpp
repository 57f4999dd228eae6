#include "volume/field/scale_kernel.h"

#include <cmath>

#include <gtest/gtest.h>

namespace isolux::volume {
namespace {

double sumOf(const HalfKernel& kernel, double power = 0.0) {
  double sum = power == 0.0 ? kernel[0] : 0.0;
  for (std::size_t k = 1; k < kernel.size(); ++k) sum += 2.0 * kernel[k] * std::pow(k, power);
  return sum;
}

TEST(ScaleKernel, SamplesHaveTheVarianceOfTheScale) {
  for (const double deviation : {0.02, 0.1, 0.3, 0.5, 0.7, 0.999, 1.0, 1.7, 6.0}) {
    const HalfKernel kernel = gaussianKernel(deviation);
    EXPECT_NEAR(sumOf(kernel), 1.0, 1e-12);
    EXPECT_NEAR(sumOf(kernel, 2.0), deviation * deviation, 1e-6 * std::max(1.0, deviation * deviation))
        << deviation;
  }
  EXPECT_EQ(gaussianKernel(0.0).size(), 1u);
  EXPECT_EQ(gaussianParameter(1.0), 1.0);  // sampling changes its variance by 2e-7: not solved for
}

TEST(ScaleKernel, TheCubicFieldSmoothesNoLessThanItsSpline) {
  EXPECT_NEAR(sumOf(smoothingKernel(scene::Field::cubic, 0.1), 2.0), 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(sumOf(smoothingKernel(scene::Field::cubic, 1.2), 2.0), 1.44, 1e-6);
  EXPECT_NEAR(sumOf(smoothingKernel(scene::Field::cubic_interpolating, 0.1), 2.0), 0.01, 1e-8);
}

TEST(ScaleKernel, ThePrefilterInvertsTheQuinticSpline) {
  const HalfKernel one = convolved(quinticPrefilter(), {66.0 / 120.0, 26.0 / 120.0, 1.0 / 120.0});
  EXPECT_NEAR(one[0], 1.0, 2e-9);
  for (std::size_t k = 1; k < one.size(); ++k) EXPECT_NEAR(one[k], 0.0, 2e-9) << k;
}

TEST(ScaleKernel, EndsOfLessThanABillionthOfTheSumAreCutOff) {
  EXPECT_EQ(cutToSumOne({1.0, 0.5, 0.4e-9, 0.5e-9}), (HalfKernel{0.5, 0.25}));  // 1.8e-9 of 2
  EXPECT_EQ(cutToSumOne({1.0, 0.5, 0.6e-9, 0.5e-9}).size(), 3u);                // 2.2e-9 of 2
  EXPECT_EQ(cutToSumOne({2.0}), HalfKernel{1.0});
}

}  // namespace
}  // namespace isolux::volume
