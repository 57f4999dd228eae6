#include "gi/sampling/built_in_light.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/color.h"
#include "scene/settings/choice_names.h"

namespace isolux::gi {
namespace {

class BuiltInLight : public ::testing::TestWithParam<scene::BuiltInLight> {};

// Who looks at the front sees the main light at the upper left: it must not come from behind or below.
TEST_P(BuiltInLight, MostLightComesFromTheUpperLeftOfTheFrontView) {
  const Environment environment = builtInEnvironment(GetParam());
  glm::dvec3 sum(0.0);
  for (int row = 0; row < environment.height(); ++row)
    for (int column = 0; column < environment.width(); ++column) {
      const glm::dvec3 d = environment.directionOf(column + 0.5, row + 0.5);
      sum +=
          base::luminance(glm::dvec3(environment.radiance(glm::vec3(d)))) * environment.solidAngle(row) * d;
    }
  EXPECT_LT(sum.x, 0.0);
  EXPECT_LT(sum.y, 0.0);
  EXPECT_GT(sum.z, 0.0);
}

TEST_P(BuiltInLight, TheImageIsTheFormula) {
  const Environment environment = builtInEnvironment(GetParam());
  EXPECT_EQ(environment.badPixels(), 0U);
  EXPECT_FALSE(environment.isConstant());
  for (int row = 3; row < environment.height(); row += 17)
    for (int column = 5; column < environment.width(); column += 13) {
      const glm::dvec3 d = environment.directionOf(column + 0.5, row + 0.5);
      const glm::dvec3 formula = builtInRadiance(GetParam(), d);
      const glm::dvec3 pixel(environment.radiance(glm::vec3(d)));
      EXPECT_LT(glm::distance(pixel, formula), 1e-4 * (1.0 + glm::length(formula)));
      EXPECT_GT(base::luminance(formula), 0.0) << "no direction is black";
    }
}

INSTANTIATE_TEST_SUITE_P(All, BuiltInLight,
                         ::testing::Values(scene::BuiltInLight::studio, scene::BuiltInLight::window,
                                           scene::BuiltInLight::overcast, scene::BuiltInLight::sunset,
                                           scene::BuiltInLight::dark_studio));

// Stored light is known by the light's name and this version: who changes a light must raise it.
TEST(BuiltInLights, AVersionStandsForTheseRadiances) {
  ASSERT_EQ(kBuiltInLightVersion, 2);
  const auto mean = [](scene::BuiltInLight light) {
    return base::luminance(builtInEnvironment(light).mean());
  };
  EXPECT_NEAR(mean(scene::BuiltInLight::studio), 0.518465, 1e-5);
  EXPECT_NEAR(mean(scene::BuiltInLight::window), 0.428678, 1e-5);
  EXPECT_NEAR(mean(scene::BuiltInLight::overcast), 0.480051, 1e-5);
  EXPECT_NEAR(mean(scene::BuiltInLight::sunset), 0.401350, 1e-5);
}

}  // namespace
}  // namespace isolux::gi
