#include "gi/sampling/batch.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/random.h"
#include "gi/sampling/directions.h"
#include "gi/sampling/environment.h"
#include "tests/support/spherical_functions.h"

namespace isolux::gi {
namespace {

using std::numbers::pi;
constexpr float below1 = 1.0f - 0x1p-24f;

float noise(std::uint64_t stream, std::uint64_t i) {
  return std::min(static_cast<float>(base::uniformNoise(stream, i)), below1);
}

// Bright and dim, with rows and pixels that are black.
Environment probe(int width, int height) {
  std::vector<glm::vec3> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const int row = static_cast<int>(i) / width;
    const bool black = (height > 3 && row % 4 == 1) || i % 7 == 2;
    if (!black || pixels.size() == 1) pixels[i] = glm::vec3(std::pow(noise(1, i), 12.0f), noise(2, i), 0.1f);
  }
  return Environment(width, height, pixels);
}

std::vector<Environment> probes() {
  std::vector<Environment> all;
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 9), std::pair(9, 1), std::pair(37, 20),
                                      std::pair(64, 32), std::pair(513, 257)})
    all.push_back(probe(width, height));
  all.push_back(Environment(8, 4, std::vector<glm::vec3>(32)));
  all.push_back(Environment::constant({1, 2, 3}));
  std::vector<glm::vec3> sun(64 * 32, glm::vec3(1e-6f));
  sun[10 * 64 + 63] = glm::vec3(1e6f);
  all.push_back(Environment(64, 32, sun));
  return all;
}

// Numbers of [0, 1)^2: both ends, edges, anything.
glm::vec2 numbers(std::uint32_t i) {
  constexpr float ends[] = {0.0f, 0x1p-24f, 0.25f, 0.5f, below1};
  if (i < 25) return {ends[i % 5], ends[i / 5]};
  if (i < 200) return {static_cast<float>(i) / 256.0f, static_cast<float>(i % 16) / 16.0f};
  return {noise(3, i), noise(4, i)};
}

TEST(SamplingBatch, SamplesAreThoseOfTheEnvironment) {
  for (const Environment& environment : probes())
    for (const std::size_t count : {std::size_t{1}, std::size_t{17}, kBatch})
      for (std::uint32_t first = 0; first < 40 * kBatch; first += kBatch) {
        BatchPairs u;
        EnvironmentBatch found;
        for (std::uint32_t i = 0; i < count; ++i) {
          u.x[i] = numbers(first + i).x;
          u.y[i] = numbers(first + i).y;
        }
        sampleBatch(environment.tables(), u, count, found);
        for (std::uint32_t i = 0; i < count; ++i) {
          const Environment::Sample sample = environment.sample({u.x[i], u.y[i]});
          ASSERT_LT(found.pixel[i], environment.pixels().size());
          ASSERT_EQ(environment.pixels()[found.pixel[i]], sample.radiance);
          ASSERT_FLOAT_EQ(found.pdf[i], sample.pdf);
          ASSERT_LT(glm::distance(found.direction[i], sample.direction), 1e-6f);
        }
      }
}

TEST(SamplingBatch, LooksUpWhatTheEnvironmentHas) {
  for (const Environment& environment : probes()) {
    EnvironmentBatch found;
    int differ = 0;  // by rounding, at the edge of a pixel
    for (std::uint32_t first = 0; first < 40 * kBatch; first += kBatch) {
      for (std::uint32_t i = 0; i < kBatch; ++i)
        found.direction.set(i, test::uniformSphere(numbers(first + i)));
      for (int axis = 0; axis < 3 && first == 0; ++axis)
        for (const float sign : {-1.0f, 1.0f}) {
          glm::vec3 direction(0.0f);
          direction[axis] = sign;
          found.direction.set(static_cast<std::size_t>(2 * axis) + (sign > 0.0f ? 1 : 0), direction);
        }
      lookUpBatch(environment.tables(), kBatch, found);
      for (std::size_t i = 0; i < kBatch; ++i) {
        const Environment::Sample seen = environment.lookUp(found.direction[i]);
        const bool same = environment.pixels()[found.pixel[i]] == seen.radiance &&
                          std::abs(found.pdf[i] - seen.pdf) <= 1e-6f * seen.pdf;
        differ += same ? 0 : 1;
      }
    }
    EXPECT_LT(differ, 10);
  }
}

// Against double precision: the disc by its angle, the basis by products.
TEST(SamplingBatch, CosineDirectionsAreRight) {
  BatchPairs u;
  BatchVectors normals, directions;
  BatchFloats cosines;
  double worst = 0.0;
  for (std::uint32_t first = 0; first < 100 * kBatch; first += kBatch) {
    for (std::uint32_t i = 0; i < kBatch; ++i) {
      u.x[i] = numbers(first + i).x;
      u.y[i] = numbers(first + i).y;
      glm::vec3 normal = test::uniformSphere({noise(5, first + i), noise(6, first + i)});
      if (i % 16 == 0) normal = glm::vec3(0, 0, i % 32 == 0 ? 1 : -1);
      if (i % 16 == 1) normal = glm::normalize(glm::vec3(1e-4f, -1e-4f, -1));
      normals.set(i, normal);
    }
    cosineBatch(u, normals, kBatch, directions, cosines);
    for (std::size_t i = 0; i < kBatch; ++i) {
      const glm::dvec3 n(normals[i]);
      const double x = 2.0 * static_cast<double>(u.x[i]) - 1.0, y = 2.0 * static_cast<double>(u.y[i]) - 1.0;
      const bool wide = std::abs(x) > std::abs(y);
      const double radius = wide ? x : y, ratio = radius != 0.0 ? (wide ? y : x) / radius : 0.0;
      const double angle = wide ? pi / 4 * ratio : pi / 2 - pi / 4 * ratio;
      const glm::dvec3 local(radius * std::cos(angle), radius * std::sin(angle),
                             std::sqrt(std::max(0.0, 1.0 - radius * radius)));
      const double sign = std::copysign(1.0, n.z), a = -1.0 / (sign + n.z), b = n.x * n.y * a;
      const glm::dvec3 tangent(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x);
      const glm::dvec3 bitangent(b, sign + n.y * n.y * a, -n.y);
      const glm::dvec3 expected = local.x * tangent + local.y * bitangent + local.z * n;
      // The height over the surface is a root: near the horizon its error is the root of the rounding.
      const double tolerance = 1e-6 + std::min(1e-6 / std::max(local.z, 1e-9), 1e-3);
      worst = std::max(worst, glm::distance(glm::dvec3(directions[i]), expected) / tolerance);
      ASSERT_NEAR(static_cast<double>(cosines[i]), local.z, tolerance);
      ASSERT_NEAR(glm::length(directions[i]), 1.0f, 1e-6f);
      ASSERT_GE(cosines[i], 0.0f);
      ASSERT_LT(
          glm::distance(directions[i], Frame::about(normals[i]).toWorld(cosineHemisphere({u.x[i], u.y[i]}))),
          1e-6f);
    }
  }
  EXPECT_LT(worst, 1.0);
}

TEST(SamplingBatch, SinesAndCosinesOfTurns) {
  double worst = 0.0;
  for (int i = -(1 << 20); i <= 1 << 20; ++i) {
    const float turn = static_cast<float>(i) * 0x1p-21f;
    float sine, cosine;
    sineCosineOfTurn(turn, sine, cosine);
    const double angle = 2.0 * pi * static_cast<double>(turn);
    worst = std::max({worst, std::abs(static_cast<double>(sine) - std::sin(angle)),
                      std::abs(static_cast<double>(cosine) - std::cos(angle))});
  }
  EXPECT_LT(worst, 1.5e-7);
  RecordProperty("largest error", std::to_string(worst));
}

}  // namespace
}  // namespace isolux::gi
