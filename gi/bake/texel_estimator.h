// Defines the interface that the bake scheduler uses to estimate the light of single texels. The scheduler
// does not depend on a tracer and is tested with analytic estimators.
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>

#include <glm/vec3.hpp>

#include "gi/lattice/light_lattice.h"

namespace isolux::gi {

// Paths [first, first + count) of every texel in a call.
struct SampleRange {
  std::uint32_t first = 0, count = 0;
};

// The position where a texel is lit, in voxel coordinates, and the outward unit normal of its isosurface
// there, in the world. The normal is 0 if it is undefined; the texel is then not lit.
struct TexelPoint {
  glm::vec3 voxel{0.0f}, normal{0.0f};
};

class TexelEstimator {
 public:
  virtual ~TexelEstimator() = default;

  virtual LightContent content() const = 0;
  virtual void points(std::span<const glm::ivec3> texels, std::span<TexelPoint> points) const = 0;
  // Adds the estimates of `range` to `sums`, components interleaved, one sample after the other in their
  // order. The sum of a texel depends only on the texel and its samples: splitting them among calls changes
  // no bit. Returns false, with `sums` undefined, when stopped; polls `stop` every few ms. Adds to `rays`.
  // Thread-safe.
  virtual bool add(std::span<const glm::ivec3> texels, std::span<const TexelPoint> points, SampleRange range,
                   std::span<double> sums, std::uint64_t& rays, const std::stop_token& stop) const = 0;
};

}  // namespace isolux::gi
