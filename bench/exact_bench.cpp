// Exact hits over ten million rays, judged by an independent search, and what sampling misses on the same
// volumes.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>
#include <glm/geometric.hpp>

#include "bench/bench.h"
#include "tests/support/rays.h"
#include "tests/support/sampled_hit.h"
#include "tests/support/test_data.h"
#include "tests/support/trilinear_oracle.h"
#include "volume/field/reconstruct.h"
#include "volume/hit/exact_hit.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::bench {
namespace {

struct Subject {
  std::string name;
  std::shared_ptr<const volume::PreparedVolume> volume;
  double isovalue;
};

std::vector<Subject> subjects() {
  base::Progress progress;
  std::vector<Subject> list;
  const auto add = [&](const char* name, const std::string& path, double isovalue) {
    scene::Source source;
    source.path = path;
    list.push_back({name, volume::loadVolume(source, progress), isovalue});
  };
  add("noise 128", "phantom:noise:128", 0.0);
  add("gyroid 128", "phantom:gyroid:128", 0.0);
  add("sheet of 0.3 voxels", "phantom:sheet:128", 0.0);
  if (const auto data = test::dataFolder(); !data.empty())
    add("ct_head_skin_bone", (data / "volumes/ct_head_skin_bone.nii.gz").string(), 0.51);
  else
    add("head phantom (no data)", "phantom:head", 300.0);
  return list;
}

constexpr std::uint64_t kRays = 10'000'000;
enum Kind : std::size_t { random, axisParallel, corners, grazing, kinds };
constexpr const char* kKindNames[kinds] = {"random", "axis-parallel", "corners, planes", "grazing"};

struct Tallies {
  test::HitTally of[kinds];
};

Kind kindOf(std::uint64_t ray) {
  return ray % 8 < 3 ? random : ray % 8 < 5 ? axisParallel : corners;
}

// A quarter of the rays are tangents of what the others hit.
Tallies judge(const Subject& subject, std::uint64_t rays) {
  const volume::Grid& grid = subject.volume->grid();
  const volume::MinMaxBlocks& blocks = *subject.volume->blocks;
  const test::TrilinearOracle oracle(grid);
  const auto hitOf = [&](const volume::Ray& ray) {
    return volume::firstHit(grid, blocks, subject.isovalue, ray);
  };
  const auto judgeRange = [&](const tbb::blocked_range<std::uint64_t>& range, Tallies sum) {
    std::uint64_t tangents = 0;
    for (std::uint64_t i = range.begin(); i != range.end(); ++i) {
      const volume::Ray ray = test::randomRay(i, grid.dims());
      const auto hit = hitOf(ray);
      test::compareHit(oracle, subject.isovalue, ray, hit, sum.of[kindOf(i)]);
      if (!hit || 3 * tangents >= i - range.begin()) continue;
      const glm::dvec3 g = volume::sampleTrilinear(grid, hit->voxel).gradient;
      if (!(glm::length(g) > 0.0)) continue;
      ++tangents;
      const volume::Ray tangent = test::grazingRay(i, hit->voxel, glm::normalize(g));
      test::compareHit(oracle, subject.isovalue, tangent, hitOf(tangent), sum.of[grazing]);
    }
    return sum;
  };
  return tbb::parallel_deterministic_reduce(tbb::blocked_range<std::uint64_t>(0, rays - rays / 4, 10000),
                                            Tallies(), judgeRange, [](Tallies a, const Tallies& b) {
                                              for (std::size_t kind = 0; kind < kinds; ++kind)
                                                a.of[kind].add(b.of[kind]);
                                              return a;
                                            });
}

struct SampledTally {
  long hits = 0, missed = 0, matched = 0;
  double squares = 0.0;
};

// Random rays; a sampled hit more than a step of the base rate behind the exact one has missed it.
void printSampled(const Subject& subject, double rate, bool adaptive) {
  const volume::Grid& grid = subject.volume->grid();
  const volume::MinMaxBlocks& blocks = *subject.volume->blocks;
  volume::SampledOptions options;
  options.rate = rate;
  options.nearThreshold = adaptive ? subject.volume->facts.typicalStep : 0.0;
  constexpr std::uint64_t rays = 200'000;
  std::vector<std::optional<volume::RayHit>> sampled(rays);
  const auto begin = std::chrono::steady_clock::now();
  for (std::uint64_t i = 0; i < rays; ++i)
    sampled[i] =
        volume::firstHitSampled(grid, blocks, subject.isovalue, test::randomRay(8 * i, grid.dims()), options);
  const double microseconds =
      std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count() / rays;
  SampledTally tally;
  for (std::uint64_t i = 0; i < rays; ++i) {
    const volume::Ray ray = test::randomRay(8 * i, grid.dims());
    const auto exact = volume::firstHit(grid, blocks, subject.isovalue, ray);
    if (!exact) continue;
    ++tally.hits;
    const double behind = sampled[i] ? (sampled[i]->t - exact->t) * glm::length(ray.direction)
                                     : std::numeric_limits<double>::infinity();
    if (std::abs(behind) > 1.0 / rate) {
      ++tally.missed;
    } else {
      ++tally.matched;
      tally.squares += behind * behind;
    }
  }
  std::printf("   rate %4.1f%s %9ld hits, missed %6ld (%.4f %%), depth %.1e voxels RMS, %.2f us a ray\n",
              rate, adaptive ? ", 8-fold near" : "             ", tally.hits, tally.missed,
              100.0 * static_cast<double>(tally.missed) / static_cast<double>(std::max(tally.hits, 1L)),
              std::sqrt(tally.squares / static_cast<double>(std::max(tally.matched, 1L))), microseconds);
}

void run() {
  const std::vector<Subject> list = subjects();
  test::HitTally total;
  for (const Subject& subject : list) {
    std::printf(" %s, isovalue %g\n", subject.name.c_str(), subject.isovalue);
    const auto begin = std::chrono::steady_clock::now();
    const Tallies tallies = judge(subject, kRays / list.size());
    for (std::size_t kind = 0; kind < kinds; ++kind) {
      const test::HitTally& t = tallies.of[kind];
      std::printf(
          "   exact, %-15s %8ld rays, %8ld hits, misses %ld, inventions %ld, touches within rounding %ld, "
          "depth within %.1e voxels\n",
          kKindNames[kind], t.rays, t.hits, t.misses, t.inventions, t.borderline, t.worstVoxels);
      total.add(t);
    }
    std::printf("   (%.0f s with the independent search)\n",
                std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    std::fflush(stdout);
    for (const double rate : {0.5, 1.0, 2.0, 4.0, 8.0})
      for (const bool adaptive : {false, true}) printSampled(subject, rate, adaptive);
  }
  std::printf(
      " exact hits of all: %ld rays, misses %ld, inventions %ld, touches within rounding %ld, depth within "
      "%.1e voxels\n",
      total.rays, total.misses, total.inventions, total.borderline, total.worstVoxels);
}

const Registration registration("exact",
                                "exact hits over 10^7 rays against an independent search; sampled hits", run);

}  // namespace
}  // namespace isolux::bench
