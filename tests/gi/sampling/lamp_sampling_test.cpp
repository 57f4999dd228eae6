// Light of lamps at the places where its formulas have no value or lose their digits. Elsewhere:
// path_tracer_lamps_test.cpp.
#include "gi/sampling/lamp_sampling.h"

#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "gi/sampling/directions.h"
#include "tests/gi/light_fixture.h"
#include "tests/support/invalid_operations.h"

namespace isolux::gi {
namespace {

using scene::LampKind;
using test::InvalidOperations;

constexpr float piFloat = std::numbers::pi_v<float>;
constexpr glm::vec3 up(0.0f, 0.0f, 1.0f);

// Voxels of 1 mm, of which (4, 4, 4) is the world's origin.
const volume::GridGeometry geometry = test::cube(9);
constexpr glm::vec3 origin(4.0f);

LampLight lampAt(LampKind kind, glm::dvec3 position, double power, double radius = 0.0) {
  LampLight lamp;
  lamp.kind = kind;
  lamp.positionMm = position;
  lamp.power = glm::dvec3(power);
  lamp.radiusMm = radius;
  return lamp;
}

TEST(LampSampler, APointLampAtThePointGivesNothing) {
  const LampLight lamps[] = {lampAt(LampKind::point, {0.0, 0.0, 0.0}, 5.0)};
  const LampSampler sampler(lamps, geometry);
  const InvalidOperations invalid;
  EXPECT_EQ(sampler.sample(0, origin, up, glm::vec2(0.5f)).irradiance, glm::vec3(0.0f));
  EXPECT_FALSE(invalid.met());
}

TEST(LampSampler, ALampAtThePointIsChosenByWhatItGivesThere) {
  // The sphere shines on the point in its middle with pi times its radiance; of the two others one is in the
  // point, too.
  const LampLight lamps[] = {lampAt(LampKind::point, {0.0, 0.0, 0.0}, 5.0),
                             lampAt(LampKind::sphere, {0.0, 0.0, 0.0}, 3.0, 2.0),
                             lampAt(LampKind::point, {0.0, 0.0, 2.0}, 4.0)};
  const LampSampler sampler(lamps, geometry);
  const float sphere = 3.0f * piFloat, point = 4.0f / 4.0f;
  const InvalidOperations invalid;
  float probability = 0.0f;
  EXPECT_EQ(sampler.choose(origin, up, 0.0f, probability), 1);
  EXPECT_NEAR(probability, sphere / (sphere + point), 1e-6f);
  EXPECT_EQ(sampler.choose(origin, up, 0.999f, probability), 2);
  EXPECT_NEAR(probability, point / (sphere + point), 1e-6f);
  EXPECT_FALSE(invalid.met());
}

// From a thousandth of a voxel on a point lamp grows no brighter, neither in its light nor for the choice.
TEST(LampSampler, APointLampGrowsNoBrighterThanAThousandthOfAVoxelAway) {
  for (const double height : {1e-5, 1e-4, 1e-3, 1e-2}) {
    const LampLight lamps[] = {lampAt(LampKind::point, {0.0, 0.0, height}, 2.0),
                               lampAt(LampKind::directional, {}, 1e6)};
    const LampSampler sampler(lamps, geometry);
    const double reach = std::max(height, 1e-3), expected = 2.0 / (reach * reach);
    // Voxels are counted from the lamp's own, so that the distance keeps its digits.
    const glm::vec3 below = origin;
    const float tolerance = height < 1e-3 ? 1e-5f : 2e-3f;  // of a distance that is a difference near 4
    EXPECT_NEAR(sampler.sample(0, below, up, glm::vec2(0.0f)).irradiance.r / expected, 1.0, tolerance)
        << height;
    float probability = 0.0f;
    ASSERT_EQ(sampler.choose(below, up, 0.0f, probability), 0);
    EXPECT_NEAR(probability / (expected / (expected + 1e6)), 1.0, tolerance) << height;
  }
}

// From everywhere inside, piFloat times the radiance, and every sample lies on the sphere.
TEST(LampSampler, InsideASphereLampTheLightIsThatOfAllDirections) {
  constexpr float radius = 3.0f;
  const LampLight lamps[] = {lampAt(LampKind::sphere, {0.0, 0.0, 0.0}, 7.0, radius)};
  const LampSampler sampler(lamps, geometry);
  for (const glm::vec3& fromCentre :
       {glm::vec3(0.0f), glm::vec3(1.0f, -2.0f, 0.5f), glm::vec3(0.0f, 0.0f, -2.9f)})
    for (std::uint32_t i = 0; i < 64; ++i) {
      const glm::vec2 u = samplePair(DirectionSequence::random, 5, i, 0);
      const LampSample sample = sampler.sample(0, origin + fromCentre, up, u);
      EXPECT_NEAR(sample.irradiance.g, 7.0f * piFloat, 1e-5f);
      EXPECT_NEAR(glm::length(fromCentre + sample.toward), radius, 2e-6f);
      EXPECT_GE(sample.toward.z, -1e-6f);  // above the surface
    }
}

// A ray along the edge of the cone touches the sphere at sqrt(d^2 - r^2), whatever rounding says of the root.
TEST(LampSampler, RaysThatTouchASphereLampEndWhereTheyTouch) {
  for (int step = 0; step < 200; ++step) {
    const double distance = 1.5 + 0.37 * step, radius = 1.0 + 0.003 * step;
    const LampLight lamps[] = {lampAt(LampKind::sphere, {0.0, 0.0, distance}, 1.0, radius)};
    const LampSampler sampler(lamps, geometry);
    const double touch = std::sqrt(distance * distance - radius * radius);
    for (const float around : {0.0f, 0.3f, 0.6f, 0.9f})
      for (const glm::vec2& u :
           {glm::vec2(std::nextafter(1.0f, 0.0f), around), glm::vec2(around, std::nextafter(1.0f, 0.0f))}) {
        const LampSample sample = sampler.sample(0, origin, up, u);
        const float length = glm::length(sample.toward);
        ASSERT_TRUE(std::isfinite(length)) << distance << ' ' << u.x << ' ' << u.y;
        EXPECT_LE(length, touch * (1.0 + 1e-5));
        EXPECT_GE(length, (distance - radius) * (1.0 - 1e-5));
      }
  }
}

TEST(LampSampler, WhereNoneShinesNoneIsChosen) {
  const LampLight behind[] = {lampAt(LampKind::point, {0.0, 0.0, -5.0}, 1.0)};
  float probability = 0.0f;
  EXPECT_EQ(LampSampler(behind, geometry).choose(origin, up, 0.5f, probability), -1);
  EXPECT_EQ(LampSampler({}, geometry).choose(origin, up, 0.5f, probability), -1);
}

// Light beyond all numbers has no shares: infinity / infinity.
TEST(LampSampler, AmongLampsOfInfiniteLightNoneIsChosen) {
  const LampLight lamps[] = {lampAt(LampKind::sphere, {0.0, 0.0, 0.0}, 2e38, 2.0),
                             lampAt(LampKind::sphere, {0.0, 0.0, 0.0}, 2e38, 3.0)};
  float probability = 0.0f;
  EXPECT_EQ(LampSampler(lamps, geometry).choose(origin, up, 0.5f, probability), -1);
}

// Shares are in proportion to the light, also at the ends of [0, 1].
TEST(LampSampler, EveryNumberOfTheIntervalChoosesALampThatShines) {
  const LampLight lamps[] = {lampAt(LampKind::point, {0.0, 0.0, 1.0}, 0.1),
                             lampAt(LampKind::point, {0.0, 0.0, 1.0}, 0.3),
                             lampAt(LampKind::point, {0.0, 0.0, -1.0}, 9.0)};
  const LampSampler sampler(lamps, geometry);
  float probability = 0.0f;
  for (const auto& [u, lamp] :
       {std::pair(0.0f, 0), std::pair(0.24f, 0), std::pair(0.26f, 1), std::pair(1.0f, 1)}) {
    EXPECT_EQ(sampler.choose(origin, up, u, probability), lamp) << u;
    EXPECT_NEAR(probability, lamp == 0 ? 0.25f : 0.75f, 1e-6f);
  }
}

}  // namespace
}  // namespace isolux::gi
