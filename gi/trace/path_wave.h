// Advances a wave of light paths together, one segment at a time. Rays are generated, traced and shaded in
// batches, so that the tracer's lanes stay full.
//
// Path i of a wave is sample samples.first + i % samples.count of point i / samples.count. At each vertex,
// direct light of the sky is estimated by one direction. The direction is sampled from the sky with
// probability `share`, else from the cosine. Its light is weighted for both (one-sample multiple importance
// sampling with the balance heuristic, Veach 1997 eq. 9.15). A path continues only in cosine-sampled
// directions, which count 1 / (1 - share) times as much. A direction sampled from the sky is a shadow ray and
// ends the path.
//
// A sky without shadows (LightScene::skyShadows) shines from every direction of every vertex, also from those
// that meet the surface and continue there. Lamps without shadows need no shadow rays.
//
// After a bounce the directions are about the B-spline normal. If that normal is 0 or does not face the
// arriving ray, they are about the normal of the trilinear cell. If neither faces it, the path continues
// straight back. A path is never dropped, so no light vanishes. Lengths are mm, positions voxel coordinates,
// directions and normals world. The random choices along a path depend only on its point's seed, its sample
// and its depth. A path is therefore the same in any wave.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "gi/sampling/batch.h"
#include "gi/sampling/lamp_sampling.h"
#include "gi/trace/path_tracer.h"
#include "volume/tracer/isosurface_tracer.h"

namespace isolux::gi {

// Paths of one wave: enough to fill the tracer, about 1 MB of state. 16384 paths are 1 % slower
// (docs/records/tried-and-not-kept.md).
inline constexpr std::size_t kWavePaths = 8192;

// Data shared by all paths of a light scene.
struct PathSetup {
  explicit PathSetup(std::shared_ptr<const LightScene> light);

  // Returns the outward unit normal for a gradient in stored units per voxel; 0 if that is 0 or not finite.
  glm::vec3 normalOf(glm::vec3 gradient) const;

  std::shared_ptr<const LightScene> light;
  LampSampler lamps;
  Sky sky;             // of radiance 1 where environment is null
  float share = 0.0f;  // fraction of directions sampled from the sky
  int bounces = 0;
  glm::mat3 voxelsOfMm{1.0f};
  glm::mat3 normalOfGradient{1.0f};  // not normalised
  float offsetMm = 0.0f;
};

// A direction in which a path sees the sky, and its weight: the estimate of E is throughput * radiance.
struct Escape {
  std::uint32_t path = 0;
  glm::vec3 throughput{0.0f};  // 0: it does not
  glm::vec3 direction{0.0f};
};

// Traces waves on one thread; keeps its memory from wave to wave.
class PathWave {
 public:
  struct Range {
    std::span<const LightPoint> points;
    SampleRange samples;
    std::size_t paths() const { return points.size() * samples.count; }
  };
  // `rays`: traced; `capped`: paths ended by kMostBounces.
  struct Counters {
    std::uint64_t rays = 0, capped = 0;
  };

  // Computes one estimate of E for each path. Returns false when stopped.
  bool skyLight(const PathSetup& setup, const Range& range, std::span<glm::vec3> light, Counters& counters,
                const std::stop_token& stop);
  bool lampLight(const PathSetup& setup, const Range& range, std::span<glm::vec3> light, Counters& counters,
                 const std::stop_token& stop);
  // Finds where each path leaves the volume, if it does; without shadows, all its directions. In the order of
  // the paths.
  bool escapes(const PathSetup& setup, const Range& range, std::vector<Escape>& escapes, Counters& counters,
               const std::stop_token& stop);
  // Computes E of the light sources without an extent directly: the same for every sample.
  bool directLight(const PathSetup& setup, std::span<const LightPoint> points, std::span<glm::vec3> light,
                   Counters& counters, const std::stop_token& stop);

 private:
  struct Vertex {
    std::uint32_t path, point;
    glm::vec3 voxel, normal, throughput;
  };
  struct Departure {
    std::uint32_t path, point;
    glm::vec3 direction, throughput;
    float cosine;
  };
  struct SkyRay {  // towards a direction sampled from the sky
    std::uint32_t path;
    glm::vec3 worth;  // if unoccluded
  };
  struct Job;  // constants of a call

  void start(const Job& job);
  void depart(const Job& job, std::uint32_t depth);
  void departBatch(const Job& job, std::uint32_t depth, std::span<const Vertex> vertices);
  void aimAtSky(const Job& job, std::span<const Vertex> vertices, std::size_t count);
  void aimByCosine(const Job& job, std::span<const Vertex> vertices, std::size_t count);
  template <class Lit, class Escaped>
  bool follow(const Job& job, const Lit& lit, const Escaped& escaped);
  bool traceFirst(const Job& job);
  bool traceAny(const Job& job, std::span<const volume::TraceRay> rays);
  void arrive(const Job& job, std::uint32_t depth);
  void aim(const Job& job, const Vertex& vertex, int lamp, glm::vec2 u, glm::vec3 throughput,
           std::span<glm::vec3> light);
  bool lightUp(const Job& job, std::span<glm::vec3> light);
  bool lightPoints(const Job& job, bool extended, std::span<glm::vec3> light);

  // Decisions of a few hundred vertices at once.
  struct Batch {
    std::uint32_t toSky[kBatch] = {}, byCosine[kBatch] = {};  // their indices
    BatchPairs skyPairs, cosinePairs;
    EnvironmentBatch sky;
    BatchVectors normals, directions;
    BatchFloats cosines;
  };

  Batch batch_;
  std::vector<Vertex> vertices_;
  std::vector<Departure> departures_;
  std::vector<SkyRay> toSky_;
  std::vector<volume::TraceRay> rays_, skyRays_;
  std::vector<float> t_;
  std::vector<std::uint8_t> hit_;
  std::vector<glm::vec3> voxels_, gradients_, albedos_;
};

}  // namespace isolux::gi
