// Rays of a light bake on one core: every instruction set of the isosurface tracer against its scalar
// version, and against Embree on the triangle mesh of one isovalue. CPU time of the thread, medians.
#include <time.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>

#include <glm/geometric.hpp>

#include "base/quantiles.h"
#include "base/random.h"
#include "bench/bench.h"
#include "bench/embree_scene.h"
#include "bench/subjects.h"
#include "bench/triangles.h"
#include "tests/support/test_data.h"
#include "volume/field/reconstruct.h"
#include "volume/tracer/isosurface_tracer.h"

namespace isolux::bench {
namespace {

using volume::IsosurfaceTracer;
using volume::TraceRay;

constexpr std::size_t kRays = std::size_t{1} << 18;
constexpr int kRounds = 5;

double threadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// The median seconds of each alternative in interleaved rounds, after one to warm up.
std::vector<double> medianSeconds(const std::vector<std::function<void()>>& alternatives) {
  std::vector<std::vector<double>> times(alternatives.size());
  for (int round = -1; round < kRounds; ++round)
    for (std::size_t i = 0; i < alternatives.size(); ++i) {
      const double begin = threadSeconds();
      alternatives[i]();
      if (round >= 0) times[i].push_back(threadSeconds() - begin);
    }
  std::vector<double> result;
  for (const auto& list : times) result.push_back(base::median(list));
  return result;
}

double random(std::uint64_t stream, std::uint64_t i) {
  return base::uniformNoise(stream, i);
}

// Cosine-distributed round the normal.
glm::dvec3 direction(glm::dvec3 normal, std::uint64_t i) {
  const double z = 2.0 * random(1, i) - 1.0, angle = 2.0 * 3.14159265358979323846 * random(2, i);
  const double r = std::sqrt(1.0 - z * z);
  return normal + 0.99999 * glm::dvec3(r * std::cos(angle), r * std::sin(angle), z);
}

// One ray of every texel with a gradient in random blocks of 16^3 texels, each with its own isovalue.
std::vector<TraceRay> texelRays(const volume::Grid& grid, std::vector<glm::vec3>& texels) {
  const glm::ivec3 blocks = (grid.dims() + 15) / 16;
  std::vector<TraceRay> rays;
  for (std::uint64_t i = 0; rays.size() < kRays; ++i) {
    const glm::ivec3 block(glm::dvec3(random(3, i), random(4, i), random(5, i)) * glm::dvec3(blocks));
    for (int texel = 0; texel < 4096 && rays.size() < kRays; ++texel) {
      const glm::ivec3 p = 16 * block + glm::ivec3(texel & 15, texel >> 4 & 15, texel >> 8);
      if (p.x >= grid.dims().x || p.y >= grid.dims().y || p.z >= grid.dims().z) continue;
      const glm::dvec3 g = volume::sampleCubic(grid, p).gradient;
      if (!(glm::length(g) > 0.0)) continue;
      const glm::dvec3 normal = -glm::normalize(g);
      rays.push_back({glm::dvec3(p) + 0.1 * normal, direction(normal, rays.size()),
                      static_cast<float>(grid.stored(p.x, p.y, p.z))});
      texels.emplace_back(p);
    }
  }
  return rays;
}

// Rays from the middles of a mesh's triangles, sorted by blocks of 16^3.
std::vector<TraceRay> surfaceRays(const volume::Grid& grid, const Triangles& mesh, double isovalue) {
  const std::size_t count = mesh.corners.size() / 3;
  const std::size_t step = std::max<std::size_t>(count / kRays, 1);
  struct Start {
    std::uint64_t block;
    TraceRay ray;
  };
  std::vector<Start> starts;
  for (std::size_t i = 0; i < count; i += step) {
    const auto corner = [&](std::size_t k) { return glm::dvec3(mesh.points[mesh.corners[3 * i + k]]); };
    const glm::dvec3 p = (corner(0) + corner(1) + corner(2)) / 3.0;
    const glm::dvec3 g = volume::sampleCubic(grid, p).gradient;
    if (!(glm::length(g) > 0.0)) continue;
    const glm::dvec3 normal = -glm::normalize(g);
    const glm::ivec3 block(p / 16.0);
    const auto key = static_cast<std::uint64_t>((block.z * 256 + block.y) * 256 + block.x);
    starts.push_back(
        {base::hash64(key), {p + 0.1 * normal, direction(normal, i), grid.storedIsovalue(isovalue)}});
  }
  std::stable_sort(starts.begin(), starts.end(),
                   [](const Start& a, const Start& b) { return a.block < b.block; });
  std::vector<TraceRay> rays;
  for (const Start& start : starts) rays.push_back(start.ray);
  return rays;
}

// Embree's scene of a mesh.
class MeshTracer {
 public:
  explicit MeshTracer(const Triangles& mesh) : scene_(mesh) {}

  void single(const std::vector<TraceRay>& rays, std::vector<float>& t, bool any) const {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      RTCRayHit hit{};
      hit.ray = {rays[i].origin.x,
                 rays[i].origin.y,
                 rays[i].origin.z,
                 0.0f,
                 rays[i].direction.x,
                 rays[i].direction.y,
                 rays[i].direction.z,
                 0.0f,
                 rays[i].tMaximum,
                 ~0u,
                 0,
                 0};
      hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      if (any) {
        scene_.occluded(hit.ray);
        t[i] = hit.ray.tfar < 0.0f ? 0.0f : kInfinity;
      } else {
        scene_.intersect(hit);
        t[i] = hit.hit.geomID != RTC_INVALID_GEOMETRY_ID ? hit.ray.tfar : kInfinity;
      }
    }
  }

  void sixteen(const std::vector<TraceRay>& rays, std::vector<float>& t, bool any) const {
    for (std::size_t first = 0; first < rays.size(); first += 16) {
      alignas(64) int valid[16];
      RTCRayHit16 hits{};
      RTCRay16& ray = hits.ray;
      for (std::size_t k = 0; k < 16; ++k) {
        valid[k] = first + k < rays.size() ? -1 : 0;
        const TraceRay& from = rays[std::min(first + k, rays.size() - 1)];
        ray.org_x[k] = from.origin.x, ray.org_y[k] = from.origin.y, ray.org_z[k] = from.origin.z;
        ray.dir_x[k] = from.direction.x, ray.dir_y[k] = from.direction.y, ray.dir_z[k] = from.direction.z;
        ray.tfar[k] = from.tMaximum;
        ray.mask[k] = ~0u;
        hits.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
      }
      if (any)
        scene_.occluded(valid, ray);
      else
        scene_.intersect(valid, hits);
      for (std::size_t k = 0; k < 16 && first + k < rays.size(); ++k) {
        const bool hit = any ? ray.tfar[k] < 0.0f : hits.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
        t[first + k] = !hit ? kInfinity : any ? 0.0f : ray.tfar[k];
      }
    }
  }

 private:
  static constexpr float kInfinity = std::numeric_limits<float>::infinity();
  EmbreeScene scene_;
};

struct Alternative {
  std::string name;
  std::function<void(const std::vector<TraceRay>&, std::vector<float>&, bool any)> trace;
};

void print(const std::vector<Alternative>& alternatives, const std::vector<TraceRay>& rays) {
  std::vector<std::vector<float>> results(2 * alternatives.size(), std::vector<float>(rays.size()));
  std::vector<std::function<void()>> runs;
  for (std::size_t i = 0; i < alternatives.size(); ++i)
    for (const bool any : {true, false})
      runs.push_back([&, i, any] { alternatives[i].trace(rays, results[2 * i + (any ? 0 : 1)], any); });
  const std::vector<double> seconds = medianSeconds(runs);
  for (std::size_t i = 0; i < alternatives.size(); ++i) {
    const auto rate = [&](std::size_t k) { return static_cast<double>(rays.size()) / seconds[k] * 1e-6; };
    const auto& t = results[2 * i + 1];
    const auto hits = std::count_if(t.begin(), t.end(), [](float v) { return std::isfinite(v); });
    std::printf("   %-16s any %6.2f Mrays/s %5.2fx   first %6.2f Mrays/s %5.2fx   hits %5.2f %%\n",
                alternatives[i].name.c_str(), rate(2 * i), seconds[0] / seconds[2 * i], rate(2 * i + 1),
                seconds[1] / seconds[2 * i + 1],
                100.0 * static_cast<double>(hits) / static_cast<double>(rays.size()));
  }
}

void compareOn(const std::string& name, const std::shared_ptr<const volume::Grid>& grid, double isovalue) {
  base::Progress progress;
  std::vector<std::unique_ptr<IsosurfaceTracer>> tracers;
  std::vector<Alternative> ours;
  for (const volume::TracerTarget target : IsosurfaceTracer::availableTargets()) {
    const auto begin = std::chrono::steady_clock::now();
    tracers.push_back(std::make_unique<IsosurfaceTracer>(grid, scene::Inside::above, progress, target));
    const double milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    const IsosurfaceTracer* tracer = tracers.back().get();
    if (tracers.size() == 1)
      std::printf(" %s, %d x %d x %d: %.0f MB beside the voxels, built in %.0f ms (all threads)\n",
                  name.c_str(), grid->dims().x, grid->dims().y, grid->dims().z,
                  1e-6 * static_cast<double>(tracer->bytes()), milliseconds);
    ours.push_back(
        {tracer->target(), [tracer](const std::vector<TraceRay>& rays, std::vector<float>& t, bool any) {
           static std::vector<std::uint8_t> hit;
           hit.resize(rays.size());
           any ? tracer->anyEntries(rays, hit) : tracer->firstEntries(rays, t);
         }});
  }
  std::vector<glm::vec3> texels;
  const std::vector<TraceRay> rays = texelRays(*grid, texels);
  std::printf("  an isovalue per texel, %zu rays\n", rays.size());
  print(ours, rays);

  std::vector<glm::vec3> gradients(texels.size());
  std::vector<std::function<void()>> runs;
  for (const auto& tracer : tracers) runs.push_back([&] { tracer->gradients(texels, gradients); });
  runs.push_back([&] {
    for (std::size_t i = 0; i < texels.size(); ++i)
      gradients[i] = volume::sampleCubic(*grid, texels[i]).gradient;
  });
  const std::vector<double> seconds = medianSeconds(runs);
  std::printf("  gradients\n");
  for (std::size_t i = 0; i < runs.size(); ++i)
    std::printf("   %-16s %6.1f ns %5.2fx\n", i < tracers.size() ? tracers[i]->target() : "sampleCubic",
                1e9 * seconds[i] / static_cast<double>(texels.size()), seconds[0] / seconds[i]);

  const Triangles mesh = trianglesOf(*grid, isovalue);
  const MeshTracer embree(mesh);
  const std::vector<TraceRay> fromSurface = surfaceRays(*grid, mesh, isovalue);
  std::printf("  isovalue %g, %zu triangles, %zu rays\n", isovalue, mesh.corners.size() / 3,
              fromSurface.size());
  ours.push_back(
      {"Embree single", [&](const auto& list, auto& t, bool any) { embree.single(list, t, any); }});
  ours.push_back(
      {"Embree 16-wide", [&](const auto& list, auto& t, bool any) { embree.sixteen(list, t, any); }});
  print(ours, fromSurface);
  std::fflush(stdout);
}

void run() {
  const auto gridOf = [](const std::string& path) {
    const VolumePointer volume = load(path);
    return std::shared_ptr<const volume::Grid>(volume, &volume->grid());
  };
  compareOn("gyroid", gridOf("phantom:gyroid:256"), 0.0);
  if (const auto data = test::dataFolder(); data.empty())
    std::printf(" ct_cranium is left out: no test data (ISOLUX_DATA)\n");
  else
    compareOn("ct_cranium", gridOf(data / "volumes/ct_cranium.mhd"), 300.0);
}

const Registration registration("tracer", "rays with an isovalue each on one core: SIMD, scalar, Embree",
                                run);

}  // namespace
}  // namespace isolux::bench
