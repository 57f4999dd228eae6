// Rays of light meet what cuts leave, and nothing else.
#include <gtest/gtest.h>

#include "tests/support/first_entry.h"
#include "tests/support/rays.h"
#include "tests/support/volumes.h"
#include "volume/tracer/isosurface_tracer.h"

namespace isolux::volume {
namespace {

constexpr std::uint64_t kRays = 20000;

scene::Scene cutScene(double size) {
  scene::Scene scene;
  scene.isosurface.value = 0.1;
  scene.extraIsosurfaces[0] = {
      .shown = true, .name = {}, .value = -0.5, .albedo = glm::dvec3(0.5), .opacity = 1.0, .clipped = false};
  scene.clip.planes = {{glm::dvec3(0.5 * size), {0.3, -0.2, 1.0}}};
  scene.clip.box = {glm::dvec3(0.1 * size), glm::dvec3(0.9 * size, 0.8 * size, 0.9 * size)};
  return scene;
}

TEST(ClipTracer, EntriesAreThoseWithinTheKeptRegion) {
  const auto grid = std::make_shared<Grid>(test::phantomGrid("gyroid", 32));
  const SurfaceCut cut(cutScene(31.0), grid->geometry());
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
      Ray ray{glm::dvec3(rays[i].origin), glm::dvec3(rays[i].direction)};
      const ClipRegion::Stretch kept =
          cut.stretchOf(static_cast<double>(rays[i].isovalue), ray.origin, ray.direction);
      const double begin = std::max(0.0, kept.begin);
      ray.origin += begin * ray.direction;
      ray.tMaximum = kept.end - begin;
      const auto entry = ray.tMaximum > 0.0 ? firstEntry(*grid, scene::Inside::above,
                                                         static_cast<double>(rays[i].isovalue), ray)
                                            : std::nullopt;
      const bool found = std::isfinite(t[i]);
      hits += found;
      different += found != entry.has_value() ||
                   (found && std::abs(begin + *entry - static_cast<double>(t[i])) > 0.01);
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
