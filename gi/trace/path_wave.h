// A wave of light paths that advance together, one segment at a time: rays are made, traced and shaded in
// batches, so that the tracer's lanes stay full.
//
// Path i of a wave is sample samples.first + i % samples.count of point i / samples.count. At each vertex of
// a path, direct light of the sky is estimated by one direction, drawn from the sky with a probability of
// `share` and else from the cosine, and weighted for both (one-sample multiple importance sampling with the
// balance heuristic, Veach 1997 eq. 9.15). A path goes on in directions of the cosine only: one that is drawn
// from the sky is a shadow ray and ends it, and the others count 1 / (1 - share) times as much. At a bounce
// the path goes on about the B-spline normal; where that does not face the arriving ray, or is 0, about the
// normal of the trilinear cell, and where that does not either, straight back: a path is never dropped, so no
// light vanishes. Lengths mm, positions voxel coordinates, directions and normals world. The decisions of a
// path depend on its point's seed, its sample and its depth only: a path is the same in any wave.
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

// Of one wave: enough to fill the tracer, some 1 MB of state. Measured: 16384 paths are 1 % slower.
inline constexpr std::size_t kWavePaths = 8192;

// What all paths of a light scene share.
struct PathSetup {
  explicit PathSetup(std::shared_ptr<const LightScene> light);

  // Outward unit normal of a gradient in stored units per voxel; 0 for a gradient that is 0 or not finite.
  glm::vec3 normalOf(glm::vec3 gradient) const;

  std::shared_ptr<const LightScene> light;
  LampSampler lamps;
  Sky sky;             // of radiance 1 where environment is null
  float share = 0.0f;  // of directions drawn from the sky
  int bounces = 0;
  glm::mat3 voxelsOfMm{1.0f};
  glm::mat3 normalOfGradient{1.0f};  // not normalised
  float offsetMm = 0.0f;
};

// Where a path left the volume, and what light from there counts: the estimate of E is
// throughput * radiance.
struct Escape {
  glm::vec3 throughput{0.0f};  // 0: it did not
  glm::vec3 direction{0.0f};
};

// Keeps its memory from wave to wave. One thread.
class PathWave {
 public:
  struct Range {
    std::span<const LightPoint> points;
    SampleRange samples;
    std::size_t paths() const { return points.size() * samples.count; }
  };
  // rays: traced; capped: paths that were ended by kMostBounces.
  struct Counters {
    std::uint64_t rays = 0, capped = 0;
  };

  // One estimate of E for each path. False when stopped.
  bool skyLight(const PathSetup& setup, const Range& range, std::span<glm::vec3> light, Counters& counters,
                const std::stop_token& stop);
  bool lampLight(const PathSetup& setup, const Range& range, std::span<glm::vec3> light, Counters& counters,
                 const std::stop_token& stop);
  // Where each path leaves, if it does.
  bool escapes(const PathSetup& setup, const Range& range, std::span<Escape> escapes, Counters& counters,
               const std::stop_token& stop);
  // E of the lamps without an extent, straight from them: the same for every sample.
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
  struct SkyRay {  // to a direction that was drawn from the sky
    std::uint32_t path;
    glm::vec3 worth;  // if nothing is in its way
  };
  struct Job;  // what is constant during a call

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
  void aim(const PathSetup& setup, float isovalue, const Vertex& vertex, const LampSample& sample,
           glm::vec3 throughput);
  bool lightUp(const Job& job, std::span<glm::vec3> light);

  // What a few hundred vertices choose at once.
  struct Batch {
    std::uint32_t toSky[kBatch] = {}, byCosine[kBatch] = {};  // which of them
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
