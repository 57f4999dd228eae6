// What the bake scheduler asks for: light of single texels. The scheduler knows no tracer, and is tested with
// estimators that are formulas.
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>

#include <glm/vec3.hpp>

#include "gi/lattice/light_lattice.h"

namespace isolux::gi {

// Paths [first, first + count) of every texel of a call.
struct SampleRange {
  std::uint32_t first = 0, count = 0;
};

// Where a texel is lit, voxel coordinates, and the outward unit normal of its isosurface there, world; 0
// where it has none and the texel is not lit.
struct TexelPoint {
  glm::vec3 voxel{0.0f}, normal{0.0f};
};

class TexelEstimator {
 public:
  virtual ~TexelEstimator() = default;

  virtual LightContent content() const = 0;
  virtual void points(std::span<const glm::ivec3> texels, std::span<TexelPoint> points) const = 0;
  // Adds the estimates of `range` to `sums`, components side by side, one sample after the other in their
  // order: how a texel's samples are cut into calls changes no bit of its sum, which depends on nothing but
  // the texel and the samples. Returns false, with `sums` undefined, when stopped; looks at `stop` every few
  // ms. `rays` counts up. Thread-safe.
  virtual bool add(std::span<const glm::ivec3> texels, std::span<const TexelPoint> points, SampleRange range,
                   std::span<double> sums, std::uint64_t& rays, const std::stop_token& stop) const = 0;
};

}  // namespace isolux::gi
