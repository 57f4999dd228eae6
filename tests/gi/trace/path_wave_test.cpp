// What paths make of gradients and radiance that are no numbers or at their end.
#include "gi/trace/path_wave.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/gi/light_fixture.h"
#include "tests/support/invalid_operations.h"

namespace isolux::gi {
namespace {

using namespace isolux::test;

LightScene wavePlane() {
  return lightSceneOf(volumeOf(cube(16), [](glm::dvec3 p) { return -p.z; }));
}

TEST(PathSetup, GradientsThatAreNoneHaveNoNormal) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                  infinity = std::numeric_limits<float>::infinity();
  const PathSetup setup(std::make_shared<const LightScene>(wavePlane()));
  const auto expectNone = [&](const glm::vec3& gradient) {
    EXPECT_EQ(setup.normalOf(gradient), glm::vec3(0.0f))
        << gradient.x << ' ' << gradient.y << ' ' << gradient.z;
  };
  const InvalidOperations invalid;
  expectNone(glm::vec3(0.0f));
  expectNone({infinity, 1.0f, 1.0f});
  expectNone({1.0f, -infinity, infinity});
  EXPECT_FALSE(invalid.met());
  expectNone({nan, 1.0f, 2.0f});  // comparisons with NaN count as invalid
  expectNone({1.0f, nan, 2.0f});
  expectNone({0.0f, 1.0f, nan});
  // Of any other size there is one: less is inside.
  for (const float size : {1e-44f, 1e-20f, 1.0f, 1e20f, 3e38f})
    EXPECT_NEAR(glm::distance(setup.normalOf({0.0f, 0.0f, -size}), glm::vec3(0.0f, 0.0f, 1.0f)), 0.0f, 1e-6f)
        << size;
}

// pi times the largest float is infinite.
TEST(PathTracer, RadianceNearTheLargestFloatGivesANumber) {
  for (const double share : {0.0, 0.5}) {
    LightScene light = wavePlane();
    light.environment = environmentOf(8, 4, [](glm::dvec3 d) { return 3.3e38 - 1e37 * d.z; });
    light.environmentShare = share;
    light.bounces = 2;
    const PathTracer tracer = tracerOf(light);
    const double seen = estimate(tracer, LightPart::sky, pointAt(tracer, glm::dvec3(0.0)), 64).luminance;
    EXPECT_TRUE(std::isfinite(seen)) << share;
    EXPECT_GT(seen, 1e36);
  }
}

}  // namespace
}  // namespace isolux::gi
