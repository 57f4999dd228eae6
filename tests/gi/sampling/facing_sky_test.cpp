// Numbers that are bent toward what a surface faces.
#include "gi/sampling/facing_sky.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "gi/sampling/directions.h"
#include "tests/gi/light_fixture.h"
#include "tests/support/analytic_fields.h"
#include "tests/support/volumes.h"

namespace isolux::gi {
namespace {

using namespace isolux::test;

constexpr double pi = std::numbers::pi;

std::shared_ptr<const Environment> cloudySky() {
  return environmentOf(64, 32, [](glm::dvec3 d) {
    const double sun = glm::dot(d, glm::normalize(glm::dvec3(0.5, 0.3, 0.7))) > 0.97 ? 40.0 : 0.0;
    return sun + 1.0 + std::sin(5.0 * d.x) * std::cos(4.0 * d.y - d.z);
  });
}

std::vector<glm::vec3> someNormals() {
  std::vector<glm::vec3> normals{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}};
  for (std::uint32_t i = 0; i < 24; ++i) {
    const glm::vec2 u = samplePair(DirectionSequence::sobol_owen, 5, i, 0);
    const float z = 1.0f - 2.0f * u.x, across = std::sqrt(1.0f - z * z), angle = 6.2831853f * u.y;
    normals.emplace_back(across * std::cos(angle), across * std::sin(angle), z);
  }
  return normals;
}

// Of even numbers: where they go, and the density that is told, agree; integrals over the square stay.
TEST(FacingSky, TheDensityIsThatOfTheNumbers) {
  const auto sky = cloudySky();
  constexpr std::uint32_t count = 1 << 14;
  for (const glm::vec3& normal : someNormals()) {
    double area = 0.0, x = 0.0, xy = 0.0;
    for (std::uint32_t i = 0; i < count; ++i) {
      const glm::vec2 u = samplePair(DirectionSequence::sobol_owen, 9, i, 0);
      const BentPair bent = bend(sky->facing().of(normal), u);
      ASSERT_GT(bent.density, 0.0f);
      ASSERT_TRUE(bent.u.x >= 0.0f && bent.u.x < 1.0f && bent.u.y >= 0.0f && bent.u.y < 1.0f);
      const double weight = 1.0 / static_cast<double>(bent.density) / count;
      area += weight;
      x += weight * static_cast<double>(bent.u.x);
      xy += weight * static_cast<double>(bent.u.x) * static_cast<double>(bent.u.y);
    }
    EXPECT_NEAR(area, 1.0, 5e-3);
    EXPECT_NEAR(x, 0.5, 3e-3);
    EXPECT_NEAR(xy, 0.25, 2e-3);
  }
}

TEST(FacingSky, MoreNumbersMeanLaterDirections) {
  const auto sky = cloudySky();
  const FacingSky::Facing& facing = sky->facing().of({0.6f, 0.0f, 0.8f});
  float before = -1.0f;
  for (int i = 0; i < 1000; ++i) {
    const float y = bend(facing, {0.5f, static_cast<float>(i) / 1000.0f}).u.y;
    EXPECT_GT(y, before);
    before = y;
  }
}

// Sums over parts of pixels of radiance times powers of the clamped cosine.
double skySum(const Environment& sky, glm::dvec3 normal, int power) {
  constexpr int parts = 4;
  double sum = 0.0;
  for (int row = 0; row < sky.height() * parts; ++row)
    for (int column = 0; column < sky.width() * parts; ++column) {
      const glm::dvec3 d = sky.directionOf((column + 0.5) / parts, (row + 0.5) / parts);
      const double cosine = glm::dot(d, normal);
      if (power > 0 && cosine <= 0.0) continue;
      const double area = 2.0 * pi * pi / (sky.height() * parts * sky.width() * parts) * std::hypot(d.x, d.y);
      sum += static_cast<double>(sky.radiance(glm::vec3(d)).x) * std::pow(cosine, power) * area;
    }
  return sum;
}

// An open plane of any tilt: the light is that of the sums, and the variance of one path a fraction of that
// of directions drawn in proportion to radiance alone, integral of L times integral of L cos^2 less E^2.
TEST(FacingSky, OpenPlanesHaveTheirLightWithLittleNoise) {
  const auto sky = cloudySky();
  const double whole = skySum(*sky, glm::dvec3(0.0), 0);
  for (const glm::vec3& normal : someNormals()) {
    LightScene light =
        lightSceneOf(volumeOf(cube(12), [n = glm::dvec3(normal)](glm::dvec3 p) { return -glm::dot(n, p); }));
    light.environment = sky;
    light.environmentShare = 0.9;
    light.sequence = scene::DirectionSequence::random;
    const PathTracer tracer = tracerOf(light);
    constexpr std::uint32_t paths = 20000;
    const Estimate e = estimate(tracer, LightPart::sky, pointAt(tracer, glm::dvec3(0.0)), paths);
    const double expected = skySum(*sky, normal, 1);
    EXPECT_TRUE(agrees(e, expected));
    EXPECT_LT(e.standardError * e.standardError * paths,
              0.5 * (whole * skySum(*sky, normal, 2) - expected * expected));
  }
}

}  // namespace
}  // namespace isolux::gi
