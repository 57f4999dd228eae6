// Rays of light meet what cuts leave, and nothing else.
#include <optional>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/first_entry.h"
#include "tests/support/rays.h"
#include "tests/support/surfaces.h"
#include "tests/support/volumes.h"
#include "volume/tracer/isosurface_tracer.h"

namespace isolux::volume {
namespace {

constexpr std::uint64_t kRays = 20000;

scene::Scene cutScene(double size) {
  scene::Scene scene;
  scene.surfaces.front().value = 0.1;
  test::surfaceAt(scene, 1) = {.id = "second",
                               .shown = true,
                               .value = -0.5,
                               .albedo = glm::dvec3(0.5),
                               .opacity = 1.0,
                               .clipped = false};
  scene.clip.planes = {{glm::dvec3(0.5 * size), {0.3, -0.2, 1.0}}};
  scene.clip.box = {glm::dvec3(0.1 * size), glm::dvec3(0.9 * size, 0.8 * size, 0.9 * size)};
  return scene;
}

// In the kept segments: the first entry, or behind a removed box the first crossing of either side.
std::optional<double> expectedEntry(const Grid& grid, const SurfaceCut& cut, const TraceRay& traced) {
  const Ray whole{glm::dvec3(traced.origin), glm::dvec3(traced.direction)};
  const auto isovalue = static_cast<double>(traced.isovalue);
  std::optional<double> first;
  for (const auto& [begin, end] : cut.segmentsOf(isovalue, whole)) {
    Ray ray{whole.origin + begin * whole.direction, whole.direction};
    ray.tMaximum = end - begin;
    for (const scene::Inside inside : {scene::Inside::above, scene::Inside::below}) {
      if (inside == scene::Inside::below && (begin == 0.0 || cut.region().removed().empty())) continue;
      const auto entry = ray.tMaximum > 0.0 ? firstEntry(grid, inside, isovalue, ray) : std::nullopt;
      if (entry && (!first || begin + *entry < *first)) first = begin + *entry;
    }
  }
  return first;
}

void expectEntries(const scene::Scene& scene) {
  const auto grid = std::make_shared<Grid>(test::phantomGrid("gyroid", 32));
  const SurfaceCut cut(scene, grid->geometry());
  base::Progress progress;
  for (const TracerTarget target : IsosurfaceTracer::availableTargets()) {
    IsosurfaceTracer tracer(grid, scene::Inside::above, progress, target);
    tracer.cut(cut);
    std::vector<TraceRay> rays;
    for (std::uint64_t i = 0; i < kRays; ++i) {
      const Ray ray = test::randomRay(i, grid->dims());
      rays.push_back({glm::vec3(ray.origin), glm::vec3(ray.direction), i % 2 == 0 ? 0.1f : -0.5f});
    }
    std::vector<float> t(rays.size());
    std::vector<std::uint8_t> any(rays.size());
    tracer.firstEntries(rays, t);
    tracer.anyEntries(rays, any);
    int hits = 0, different = 0, outside = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const auto entry = expectedEntry(*grid, cut, rays[i]);
      const bool found = std::isfinite(t[i]);
      hits += found;
      different +=
          found != entry.has_value() || (found && std::abs(*entry - static_cast<double>(t[i])) > 0.01);
      different += (any[i] != 0) != found;
      if (found && i % 2 == 0)
        outside += !cut.region().contains(glm::dvec3(rays[i].origin) + (static_cast<double>(t[i]) - 1e-3) *
                                                                           glm::dvec3(rays[i].direction)) &&
                   !cut.region().contains(glm::dvec3(rays[i].origin) +
                                          (static_cast<double>(t[i]) + 1e-3) * glm::dvec3(rays[i].direction));
    }
    EXPECT_GT(hits, 5000);
    EXPECT_EQ(outside, 0);
    EXPECT_LT(different, 20) << tracer.target();  // whose answer hangs on the last digits
  }
}

TEST(ClipTracer, EntriesAreThoseWithinTheKeptRegion) {
  expectEntries(cutScene(31.0));
}

TEST(ClipTracer, EntriesAreThoseBesideRemovedBoxes) {
  scene::Scene scene = cutScene(31.0);
  scene.clip.removed = {{12, 10, 8}, {99, 99, 22}, {5, 5, 5}, {12, 14, 20}, {16, 2, 3}, {20, 12, 12}};
  expectEntries(scene);
  scene.clip.planes.clear();
  scene.clip.box.clear();
  expectEntries(scene);
}

// A ball without an octant. From the octant a ray goes in through the cut face and meets the ball's inner
// side where it would leave it; on its way from outside through the octant, too.
TEST(ClipTracer, WhatComesInThroughACutFaceDoesNotLeaveAtTheOtherSide) {
  const glm::dvec3 middle(15.5);
  const auto grid = std::make_shared<Grid>(test::gridOfVoxels(
      test::unitGeometry(glm::ivec3(32)), [&](glm::dvec3 p) { return 10.0 - glm::distance(p, middle); }));
  scene::Scene scene;
  scene.surfaces.front().value = 0.0;
  scene.clip.removed = {middle, glm::dvec3(1e6)};
  base::Progress progress;
  for (const TracerTarget target : IsosurfaceTracer::availableTargets()) {
    IsosurfaceTracer tracer(grid, scene::Inside::above, progress, target);
    tracer.cut(SurfaceCut(scene, grid->geometry()));
    std::vector<TraceRay> rays;
    std::vector<double> expected;
    for (std::uint64_t i = 0; i < 1000; ++i) {
      const glm::dvec3 inOctant = middle + test::randomPoint(i, glm::dvec3(1), glm::dvec3(5)),
                       to = middle - test::randomPoint(i, glm::dvec3(1), glm::dvec3(4)),
                       along = glm::normalize(to - inOctant);
      for (const double before : {0.0, 20.0}) {
        const glm::dvec3 origin = inOctant - before * along, from = origin - middle;
        const double b = glm::dot(from, along);
        rays.push_back({glm::vec3(origin), glm::vec3(along), 0.0f});
        expected.push_back(-b + std::sqrt(b * b - glm::dot(from, from) + 100.0));
      }
    }
    std::vector<float> t(rays.size());
    std::vector<std::uint8_t> any(rays.size());
    tracer.firstEntries(rays, t);
    tracer.anyEntries(rays, any);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      EXPECT_NEAR(t[i], expected[i], 0.05) << tracer.target() << ' ' << i;
      EXPECT_EQ(any[i], 1);
    }
  }
}

TEST(ClipTracer, OtherSidesAndWholeOnesAreCutAlike) {
  const auto grid = std::make_shared<Grid>(test::phantomGrid("gyroid", 20));
  base::Progress progress;
  IsosurfaceTracer tracer(grid, scene::Inside::above, progress);
  tracer.cut(SurfaceCut(cutScene(19.0), grid->geometry()));
  EXPECT_NE(tracer.cut().key(), 0u);
  EXPECT_EQ(tracer.otherSide(progress)->cut().key(), tracer.cut().key());
  EXPECT_EQ(tracer.withAllPieces()->cut().key(), tracer.cut().key());
}

}  // namespace
}  // namespace isolux::volume
