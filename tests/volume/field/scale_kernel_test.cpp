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

}  // namespace
}  // namespace isolux::volume
