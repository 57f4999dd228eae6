// Errors of irradiance on numbers made by hand. Nothing here needs GL.
#include "app/study/light_errors.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace isolux::app {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

LightReference referenceOf(std::vector<glm::dvec3> irradiance, double variance) {
  LightReference reference;
  for (std::size_t i = 0; i < irradiance.size(); ++i) reference.pixels.push_back(i);
  reference.variance.assign(irradiance.size(), glm::dvec3(variance));
  reference.irradiance = std::move(irradiance);
  return reference;
}

TEST(LightErrors, EveryChannelOfEveryPixelCounts) {
  const LightReference reference = referenceOf({glm::dvec3(1.0), glm::dvec3(3.0)}, 0.0);
  const LightErrors errors = lightErrorsOf({1.5f, 1.0f, 1.0f, 3.0f, 3.0f, 2.0f}, reference);
  EXPECT_EQ(errors.pixels, 2u);
  EXPECT_DOUBLE_EQ(errors.mean, 2.0);
  EXPECT_DOUBLE_EQ(errors.rmse, std::sqrt((0.25 + 1.0) / 6.0));
  EXPECT_DOUBLE_EQ(errors.bias, (0.5 - 1.0) / 6.0);
  EXPECT_DOUBLE_EQ(errors.maximum, -1.0);
  EXPECT_EQ(errors.maximumPixel, 1u);
  EXPECT_TRUE(std::isnan(errors.maximumZ)) << "the truth has no noise to compare with";
  EXPECT_DOUBLE_EQ(errors.relative(0.5), 0.25);
}

TEST(LightErrors, PixelsAreThoseOfThePicture) {
  LightReference reference = referenceOf({glm::dvec3(1.0), glm::dvec3(2.0)}, 0.0);
  reference.pixels = {3, 1};
  std::vector<float> drawn(12, 7.0f);
  std::fill_n(drawn.begin() + 9, 3, 1.0f);
  std::fill_n(drawn.begin() + 3, 3, 2.0f);
  EXPECT_DOUBLE_EQ(lightErrorsOf(drawn, reference).rmse, 0.0);
  drawn[9] = nan;
  EXPECT_EQ(lightErrorsOf(drawn, reference).pixels, 1u) << "no surface is drawn there";
  drawn[3] = nan;
  const LightErrors none = lightErrorsOf(drawn, reference);
  EXPECT_EQ(none.pixels, 0u);
  EXPECT_TRUE(std::isnan(none.rmse) && std::isnan(none.bias) && std::isnan(none.maximum));
}

TEST(LightErrors, TheLargestIsToldInStandardErrorsOfTheTruth) {
  LightReference reference = referenceOf({glm::dvec3(1.0), glm::dvec3(1.0)}, 0.01);
  reference.variance[1] = glm::dvec3(0.25);
  const LightErrors errors = lightErrorsOf({1.1f, 1.0f, 1.0f, 1.0f, 2.0f, 1.0f}, reference);
  EXPECT_DOUBLE_EQ(errors.maximum, 1.0);
  EXPECT_DOUBLE_EQ(errors.maximumZ, 2.0);
  EXPECT_DOUBLE_EQ(errors.truthNoise, std::sqrt((0.01 + 0.25) / 2.0));
}

TEST(LightErrors, BlackLightHasNoRelativeError) {
  const LightErrors errors = lightErrorsOf({0.0f, 0.0f, 0.0f}, referenceOf({glm::dvec3(0.0)}, 0.0));
  EXPECT_EQ(errors.rmse, 0.0);
  EXPECT_TRUE(std::isnan(errors.relative(errors.rmse)));
}

// A picture off by normal errors of known size, beside a truth that is as noisy as that, or noisier.
TEST(LightErrors, TheNoiseOfTheTruthIsTakenOut) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  for (const double noise : {0.0, 0.1, 0.3}) {
    for (const double size : {0.0, 0.1}) {
      LightReference reference;
      std::vector<float> drawn;
      for (std::size_t i = 0; i < 4000; ++i) {
        glm::dvec3 estimate;
        for (int channel = 0; channel < 3; ++channel) {
          estimate[channel] = 2.0 + noise * normal(random);
          drawn.push_back(static_cast<float>(2.0 + size * normal(random)));
        }
        reference.pixels.push_back(i);
        reference.irradiance.push_back(estimate);
        reference.variance.emplace_back(noise * noise);
      }
      const LightErrors errors = lightErrorsOf(drawn, reference);
      const double upper = errors.rmse + errors.rmseStandardError;
      const double standardError = upper * upper - errors.rmse * errors.rmse;  // of the mean square
      EXPECT_LE(std::abs(errors.rmse * errors.rmse - size * size), 4.5 * standardError + 1e-12)
          << noise << ' ' << size;
      EXPECT_LE(std::abs(errors.bias), 4.5 * errors.biasStandardError + 1e-12);
      if (size > 0.0) {
        EXPECT_LT(errors.rmseStandardError, 0.15 * size) << "and it says how sure that is";
      }
      EXPECT_NEAR(errors.truthNoise, noise, 1e-12);
    }
  }
}

}  // namespace
}  // namespace isolux::app
