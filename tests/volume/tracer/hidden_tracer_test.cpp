#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/hidden_balls.h"
#include "tests/support/rays.h"
#include "volume/hit/exact_hit.h"
#include "volume/tracer/isosurface_tracer.h"

namespace isolux::volume {
namespace {

constexpr std::uint64_t kHiddenRays = 60000;

std::vector<TraceRay> raysOf(glm::ivec3 dims, std::initializer_list<float> isovalues) {
  std::vector<TraceRay> rays;
  for (std::uint64_t i = 0; i < kHiddenRays; ++i) {
    const Ray ray = test::randomRay(i, dims);
    rays.push_back(
        {glm::vec3(ray.origin), glm::vec3(ray.direction), isovalues.begin()[i % isovalues.size()]});
  }
  return rays;
}

std::shared_ptr<const IsosurfaceTracer> tracerOf(const Grid& grid, scene::Inside inside, TracerTarget target,
                                                 std::vector<HiddenOfSurface> hidden = {}) {
  base::Progress progress;
  auto tracer = std::make_shared<IsosurfaceTracer>(std::make_shared<Grid>(grid), inside, progress, target);
  tracer->hide(hidden, progress);
  return tracer;
}

void expectSameEntries(const IsosurfaceTracer& tracer, const IsosurfaceTracer& expected,
                       const std::vector<TraceRay>& rays) {
  std::vector<float> t(rays.size()), expectedT(rays.size());
  tracer.firstEntries(rays, t);
  expected.firstEntries(rays, expectedT);
  EXPECT_EQ(t, expectedT);
  std::vector<std::uint8_t> hit(rays.size()), expectedHit(rays.size());
  tracer.anyEntries(rays, hit);
  expected.anyEntries(rays, expectedHit);
  EXPECT_EQ(hit, expectedHit);
}

TEST(HiddenTracer, EntriesAreThoseOfAVolumeWithoutTheHiddenBalls) {
  const auto hidden = std::make_shared<VoxelMask>(test::hiddenOfBalls(test::pieceBalls()));
  const std::vector<TraceRay> rays = raysOf(hidden->dims(), {0.0f});
  base::Progress progress;
  for (const double sign : {1.0, -1.0})
    for (const TracerTarget target : IsosurfaceTracer::availableTargets()) {
      const scene::Inside inside = sign > 0.0 ? scene::Inside::above : scene::Inside::below;
      const auto all = tracerOf(test::gridOfBalls(test::pieceBalls(), true, sign), inside, target,
                                {{0.0, hidden, inside}}),
                 shown = tracerOf(test::gridOfBalls(test::pieceBalls(), false, sign), inside, target);
      expectSameEntries(*all, *shown, rays);
      expectSameEntries(*all->otherSide(progress), *shown->otherSide(progress), rays);
    }
}

TEST(HiddenTracer, OtherIsovaluesMeetAllPieces) {
  const auto hidden = std::make_shared<VoxelMask>(test::hiddenOfBalls(test::pieceBalls()));
  const Grid grid = test::gridOfBalls(test::pieceBalls(), true);
  const std::vector<TraceRay> mixed = raysOf(hidden->dims(), {0.0f, 0.5f});
  for (const TracerTarget target : IsosurfaceTracer::availableTargets()) {
    const auto hiding = tracerOf(grid, scene::Inside::above, target, {{0.0, hidden, scene::Inside::above}}),
               all = tracerOf(grid, scene::Inside::above, target),
               without = tracerOf(test::gridOfBalls(test::pieceBalls(), false), scene::Inside::above, target);
    std::vector<float> t(mixed.size()), ofAll(mixed.size()), ofShown(mixed.size());
    hiding->firstEntries(mixed, t);
    all->firstEntries(mixed, ofAll);
    without->firstEntries(mixed, ofShown);
    int passed = 0;
    for (std::size_t i = 0; i < mixed.size(); ++i) {
      ASSERT_EQ(t[i], i % 2 == 0 ? ofShown[i] : ofAll[i]) << i;
      passed += ofShown[i] != ofAll[i];
    }
    EXPECT_GT(passed, 4000);
    const auto whole = hiding->withAllPieces();
    EXPECT_TRUE(whole->hidden().empty());
    expectSameEntries(*whole, *all, mixed);
  }
}

// In cells of two pieces: as the double precision reference has it.
TEST(HiddenTracer, InCellsOfTwoPiecesEntriesAreOfTheShownOne) {
  const Grid grid = test::SplitCells::grid();
  base::Progress progress;
  const MinMaxBlocks blocks(grid, 8, progress);
  const auto hidden = std::make_shared<VoxelMask>(test::SplitCells::hidden());
  const std::vector<TraceRay> rays = raysOf(grid.dims(), {0.0f});
  for (const TracerTarget target : IsosurfaceTracer::availableTargets()) {
    const auto tracer = tracerOf(grid, scene::Inside::above, target, {{0.0, hidden, scene::Inside::above}});
    std::vector<float> t(rays.size());
    tracer->firstEntries(rays, t);
    int compared = 0, wrong = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (i % 8 >= 3) continue;  // crossings that rounding decides
      const glm::dvec3 origin(rays[i].origin), direction(rays[i].direction);
      auto hit = firstHit(grid, blocks, 0.0, {origin, direction, 0.0}, {hidden.get(), scene::Inside::above});
      while (hit && !hit->entering)
        hit = firstHit(grid, blocks, 0.0, {origin, direction, hit->t + 1e-9 / glm::length(direction)},
                       {hidden.get(), scene::Inside::above});
      ++compared;
      const double length = glm::length(direction);
      wrong += hit.has_value() != std::isfinite(t[i]) ||
               (hit && std::abs(hit->t - static_cast<double>(t[i])) * length > 2e-3);
    }
    EXPECT_GT(compared, 20000);
    EXPECT_LT(wrong, compared / 1000) << tracer->target();  // rays that graze
  }
}

}  // namespace
}  // namespace isolux::volume
