// Directions for many paths at once, one per SIMD lane: what directions.h and environment.h tell of one
// direction, in the same arithmetic without fused products, so that a number does not depend on the lane that
// it came from.
//
// A batch is arrays of kBatch numbers, of which the first `count` are asked for; whole vectors are computed,
// and what lies behind `count` is any number. Immutable; any thread.
#pragma once

#include <cstddef>
#include <cstdint>

#include <glm/vec3.hpp>

namespace isolux::gi {

inline constexpr std::size_t kBatch =
    256;  // some ten kilobytes: what a stage asks for the next one finds near

struct alignas(64) BatchFloats {
  float v[kBatch] = {};
  float& operator[](std::size_t i) { return v[i]; }
  float operator[](std::size_t i) const { return v[i]; }
};
struct alignas(64) BatchWords {
  std::uint32_t v[kBatch] = {};
  std::uint32_t& operator[](std::size_t i) { return v[i]; }
  std::uint32_t operator[](std::size_t i) const { return v[i]; }
};
struct BatchVectors {
  BatchFloats x, y, z;
  glm::vec3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
  void set(std::size_t i, glm::vec3 value) { x[i] = value.x, y[i] = value.y, z[i] = value.z; }
};
struct BatchPairs {
  BatchFloats x, y;  // in [0, 1)
};

// What an environment is sampled by (environment.h, guide_table.h). Fewer than 2^31 pixels.
struct EnvironmentTables {
  int width = 0, height = 0;
  const float* pixels = nullptr;                                    // three each
  const std::uint32_t *rowStart = nullptr, *columnStart = nullptr;  // row after row
  const std::uint32_t *rowGuide = nullptr, *columnGuide = nullptr;  // of columns row after row
  const float *rowDensity = nullptr, *sineSquaredHalf = nullptr;
};
struct EnvironmentBatch {
  BatchVectors direction;
  BatchFloats pdf;
  BatchWords pixel;
};

// As Environment::sample().
void sampleBatch(const EnvironmentTables& tables, const BatchPairs& u, std::size_t count,
                 EnvironmentBatch& samples);
// As Environment::lookUp(), of samples.direction.
void lookUpBatch(const EnvironmentTables& tables, std::size_t count, EnvironmentBatch& samples);
// As Frame::about(normal).toWorld(cosineHemisphere(u)); cosines: of the directions with the normals.
void cosineBatch(const BatchPairs& u, const BatchVectors& normals, std::size_t count,
                 BatchVectors& directions, BatchFloats& cosines);

}  // namespace isolux::gi
