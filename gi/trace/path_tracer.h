// Computes irradiance or spherical-harmonic transfer at surface points by path tracing, unbiased.
//
// Each point is lit on its own isosurface: every ray of its paths is traced against that isovalue (Wyman et
// al. 2006 sec. 4.1). Directions are cosine-distributed about the B-spline normal. A fraction of them are
// shadow rays towards directions sampled from the environment instead. Direct light of the environment is
// weighted for both (one-sample multiple importance sampling, balance heuristic: Veach 1997 sec. 9.2.4).
// Light sources are sampled by shadow rays. Paths never branch, and end by Russian roulette. Direct light of
// a source without shadows is unoccluded at every vertex; paths are the same.
//
// Rays start off the surface by kOffsetVoxels along the normal; the light of a source is evaluated at the
// point itself. The result for a point and a sample number does not depend on other requests. A path that has
// not ended after kMostBounces (albedo 1 in a closed cavity) is ended and counted. Thread-safe.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>

#include <glm/vec3.hpp>

#include "gi/bake/texel_estimator.h"
#include "gi/light_scene.h"

namespace isolux::gi {

inline constexpr float kOffsetVoxels = 0.1f;  // fraction of the shortest voxel axis
inline constexpr int kMostBounces = 1000;     // of any path; the maximum of gi.bounces

struct PathSetup;  // gi/trace/path_wave.h

struct LightPoint {
  glm::vec3 voxel{0.0f};
  float isovalue = 0.0f;   // stored units
  glm::vec3 normal{0.0f};  // unit, world, outward
  std::uint32_t seed = 0;  // of its direction pattern: the number of a texel or pixel
};

class PathTracer {
 public:
  explicit PathTracer(std::shared_ptr<const LightScene> light);

  // Computes mean estimates of E over `range` for each point, of the sky or of the light sources. `variances`
  // (empty, or one per point): the sample variance of one path's luminance of E, from the same paths (0 for
  // one sample). Returns false when stopped.
  bool irradiance(LightPart part, std::span<const LightPoint> points, SampleRange range,
                  std::span<glm::vec3> means, std::span<float> variances, std::uint64_t& rays,
                  const std::stop_token& stop) const;
  // Adds the same estimates, of the first `channels`, to each point's sums in the order of the samples. The
  // sums are bit-identical however the samples are split among calls.
  bool addIrradiance(LightPart part, std::span<const LightPoint> points, SampleRange range, int channels,
                     std::span<double> sums, std::uint64_t& rays, const std::stop_token& stop) const;
  // Adds transfer vectors, light.choice.channels * order^2 numbers per point (LightContent), in the same way.
  bool addTransfer(std::span<const LightPoint> points, SampleRange range, std::span<double> sums,
                   std::uint64_t& rays, const std::stop_token& stop) const;

  // Returns the outward unit normal, world, for a gradient of IsosurfaceTracer::gradients(); 0 if undefined.
  glm::vec3 normalOf(glm::vec3 gradient) const;

  const LightScene& light() const;
  const PathSetup& setup() const { return *setup_; }
  // Returns the number of paths so far that were ended by kMostBounces: their remaining light is missing.
  std::uint64_t cappedPaths() const { return capped_->load(std::memory_order_relaxed); }

 private:
  // Calls each(point, direct light, estimate) for all samples of a point in their order.
  template <class Each>
  bool forEachEstimate(LightPart part, std::span<const LightPoint> points, SampleRange range,
                       std::uint64_t& rays, const std::stop_token& stop, const Each& each) const;

  std::shared_ptr<const PathSetup> setup_;
  std::shared_ptr<std::atomic<std::uint64_t>> capped_;  // shared by all copies
};

}  // namespace isolux::gi
