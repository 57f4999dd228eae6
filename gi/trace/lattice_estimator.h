// Estimates the light of a lattice's texels by the path tracer. Determines position, isovalue (the texel's
// own, or the lattice's) and B-spline normal of each texel.
#pragma once

#include <memory>

#include "gi/trace/path_tracer.h"

namespace isolux::gi {

class LatticeEstimator : public TexelEstimator {
 public:
  LatticeEstimator(std::shared_ptr<const LightScene> light, const LatticeGeometry& geometry, LightPart part);
  LightContent content() const override;
  void points(std::span<const glm::ivec3> texels, std::span<TexelPoint> points) const override;
  bool add(std::span<const glm::ivec3> texels, std::span<const TexelPoint> points, SampleRange range,
           std::span<double> sums, std::uint64_t& rays, const std::stop_token& stop) const override;

 private:
  PathTracer tracer_;
  LatticeGeometry geometry_;
  LightPart part_;
};

}  // namespace isolux::gi
