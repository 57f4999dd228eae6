#include "gi/harmonics/open_sky.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace isolux::gi {
namespace {

// Irradiance of mean 2 that rises along z, of the first channel alone.
std::array<glm::vec3, 9> risingRed(float rise) {
  std::array<glm::vec3, 9> sh{};
  sh[0].r = 2.0f / std::sqrt(0.25f / std::numbers::pi_v<float>);
  sh[2].r = rise;
  return sh;
}

TEST(OpenSkyTest, IsInPartsOfItsMean) {
  const float rise = 1.0f;
  const OpenSky sky(risingRed(rise));
  EXPECT_NEAR(sky.perMean().r, 0.5f, 1e-6f);
  // The harmonic of z is sqrt(3 / 4 pi) z.
  const float steep = 0.5f * rise * std::sqrt(0.75f / std::numbers::pi_v<float>);
  EXPECT_NEAR(sky.at({0.0f, 0.0f, 1.0f}).r, 1.0f + steep, 1e-5f);
  EXPECT_NEAR(sky.at({1.0f, 0.0f, 0.0f}).r, 1.0f, 1e-5f);
}

TEST(OpenSkyTest, AChannelWithoutLightIsTheSameForAllNormals) {
  const OpenSky sky(risingRed(1.0f));
  EXPECT_EQ(sky.perMean().g, 0.0f);
  for (const float z : {-1.0f, 1.0f}) EXPECT_EQ(sky.at({0.0f, 0.0f, z}).g, kLeastOpenSky);
}

TEST(OpenSkyTest, IsNeverBelowItsLeast) {
  const OpenSky sky(risingRed(20.0f));
  EXPECT_EQ(sky.at({0.0f, 0.0f, -1.0f}).r, kLeastOpenSky);
}

TEST(OpenSkyTest, RoundingMakesNoOtherSky) {
  const OpenSky sky(risingRed(1.0f));
  EXPECT_TRUE(sky.nearly(OpenSky(risingRed(1.00001f))));
  EXPECT_FALSE(sky.nearly(OpenSky(risingRed(1.01f))));
}

}  // namespace
}  // namespace isolux::gi
