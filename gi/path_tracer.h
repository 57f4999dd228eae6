// Light of surface points by path tracing: irradiance or spherical harmonic transfer, unbiased.
//
// Each point is lit on its own isosurface: every ray of its paths is traced against that isovalue (Wyman et
// al. 2006 sec. 4.1). Directions are cosine-distributed about the B-spline normal, mixed with directions
// drawn from the environment (one-sample multiple importance sampling, balance heuristic: Veach 1997
// sec. 9.2.4); lamps by shadow rays; paths go on in one direction, never branch, and end by Russian roulette.
// Rays start off the surface by kOffsetVoxels along the normal. Stateless: the result for a point and a
// sample number is always the same. Thread-safe.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>

#include <glm/vec3.hpp>

#include "gi/light_scene.h"
#include "gi/texel_estimator.h"

namespace isolux::gi {

inline constexpr float kOffsetVoxels = 0.1f;  // of the shortest voxel axis

struct LightPoint {
  glm::vec3 voxel{0.0f};
  float isovalue = 0.0f;   // stored units
  glm::vec3 normal{0.0f};  // unit, world, outward
  std::uint32_t seed = 0;  // of its pattern of directions: a texel's or pixel's number
};

class PathTracer {
 public:
  explicit PathTracer(std::shared_ptr<const LightScene> light);

  // Mean estimates of E over `range` for each point, of the sky or of the lamps; `variances` (empty, or one a
  // point): the sample variance of one path's luminance of E, from the same paths (0 for one sample). False
  // when stopped.
  bool irradiance(LightPart part, std::span<const LightPoint> points, SampleRange range,
                  std::span<glm::vec3> means, std::span<float> variances, std::uint64_t& rays,
                  std::stop_token stop) const;
  // Mean transfer vectors, light.choice.channels * order^2 floats a point (LightContent).
  bool transfer(std::span<const LightPoint> points, SampleRange range, std::span<float> means,
                std::uint64_t& rays, std::stop_token stop) const;

  const LightScene& light() const { return *light_; }

 private:
  std::shared_ptr<const LightScene> light_;
};

// The texels of a lattice as points: position, own isovalue, B-spline normal.
class LatticeEstimator : public TexelEstimator {
 public:
  LatticeEstimator(std::shared_ptr<const LightScene> light, LatticeGeometry geometry, LightPart part);
  LightContent content() const override;
  void normals(std::span<const glm::ivec3> texels, std::span<glm::vec3> normals) const override;
  bool estimate(std::span<const glm::ivec3> texels, std::span<const glm::vec3> normals, SampleRange range,
                std::span<float> means, std::uint64_t& rays, std::stop_token stop) const override;

 private:
  PathTracer tracer_;
  LatticeGeometry geometry_;
  LightPart part_;
};

}  // namespace isolux::gi
