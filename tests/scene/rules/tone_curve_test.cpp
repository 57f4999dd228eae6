#include "scene/rules/tone_curve.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/vec3.hpp>

namespace isolux::scene {
namespace {

double grey(double value) {
  return filmic(glm::dvec3(value)).x;
}

TEST(ToneCurve, LeavesColoursUpToTheKneeAsTheyAre) {
  for (const glm::dvec3& color : {glm::dvec3(0.0), glm::dvec3(0.5), glm::dvec3(0.1, 0.5, 0.3)})
    EXPECT_EQ(filmic(color), color);
}

TEST(ToneCurve, RisesSmoothlyAndStaysBelowWhite) {
  constexpr double step = 1e-6;
  EXPECT_NEAR((grey(kToneKnee + step) - grey(kToneKnee)) / step, 1.0, 1e-5);
  for (double value = 0.4; value < 1e6; value *= 1.2) {
    EXPECT_LT(grey(value), grey(1.2 * value));
    EXPECT_LT(grey(1.2 * value), 1.0);
  }
}

TEST(ToneCurve, KeepsTheHueAndEndsInWhite) {
  const glm::dvec3 color(0.9, 0.3, 0.1), shown = filmic(color);
  EXPECT_NEAR((shown.y - shown.z) / (shown.x - shown.z), (color.y - color.z) / (color.x - color.z), 1e-12);
  EXPECT_NEAR(shown.x, 1.0 - 0.25 / 0.9, 1e-12);
  const glm::dvec3 glare = filmic(1e5 * color);
  EXPECT_GT(glare.z, 0.999);
}

}  // namespace
}  // namespace isolux::scene
