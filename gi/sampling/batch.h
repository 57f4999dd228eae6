// Samples directions for many paths at once, one per SIMD lane.
//
// Each function computes what directions.h or environment.h computes for one direction. The arithmetic is the
// same, without fused multiply-add (FMA), so a result does not depend on its lane.
//
// A batch is arrays of kBatch numbers, of which the first `count` are requested. Whole vectors are computed;
// the numbers behind `count` are undefined. Immutable; safe from any thread.
#pragma once

#include <cstddef>
#include <cstdint>

#include <glm/vec3.hpp>

namespace isolux::gi {

inline constexpr std::size_t kBatch =
    256;  // some ten kilobytes: the results of a stage are still in the cache for the next

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

// The tables that an environment is sampled with (environment.h, guide_table.h). Fewer than 2^31 pixels.
struct EnvironmentTables {
  int width = 0, height = 0;
  const float* pixels = nullptr;                                    // three each
  const std::uint32_t *rowStart = nullptr, *columnStart = nullptr;  // row by row
  const std::uint32_t *rowGuide = nullptr, *columnGuide = nullptr;  // columns row by row
  const float *rowDensity = nullptr, *sineSquaredHalf = nullptr;
};
struct EnvironmentBatch {
  BatchVectors direction;
  BatchFloats pdf;
  BatchWords pixel;
};

// Samples as Environment::sample().
void sampleBatch(const EnvironmentTables& tables, const BatchPairs& u, std::size_t count,
                 EnvironmentBatch& samples);
// Looks up samples.direction as Environment::lookUp().
void lookUpBatch(const EnvironmentTables& tables, std::size_t count, EnvironmentBatch& samples);
// Computes Frame::about(normal).toWorld(cosineHemisphere(u)). `cosines`: between the directions and the
// normals.
void cosineBatch(const BatchPairs& u, const BatchVectors& normals, std::size_t count,
                 BatchVectors& directions, BatchFloats& cosines);

}  // namespace isolux::gi
