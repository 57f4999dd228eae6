// Crossings of the cubic fields, on every target of this machine (caster_checks.h).
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/random.h"
#include "tests/support/volumes.h"
#include "tests/volume/cast/caster_checks.h"
#include "volume/field/reconstruct.h"
#include "volume/field/value_scaling.h"

namespace isolux::volume {
namespace {

using namespace test::casting;

constexpr scene::Field kCubicFields[] = {scene::Field::cubic, scene::Field::cubic_interpolating};

TEST(CubicCaster, FindsWhatTheReferenceFinds) {
  for (const scene::Field field : kCubicFields) {
    expectFirstHits({test::phantomGrid("gyroid", 32), {0.1}, field}, "gyroid", 4);
    expectFirstHits({test::phantomGrid("noise", 24), {0.0}, field}, "noise", 4);
  }
  // The smoothing spline has no such sheet any more.
  expectFirstHits({test::phantomGrid("sheet", 48), {0.0}, scene::Field::cubic_interpolating}, "sheet", 4);
}

// Nearly every cell is crossed, many of them several times.
TEST(CubicCaster, FindsWhatTheReferenceFindsInWhiteNoise) {
  const auto hashed = [](glm::dvec3 p) {
    return base::hash64(static_cast<std::uint64_t>((p.z * 97.0 + p.y) * 97.0 + p.x));
  };
  const Grid noise = test::gridOfVoxels(test::unitGeometry(glm::ivec3(20)), [&](glm::dvec3 p) {
    return static_cast<double>(hashed(p) % 1000000) / 1e6;
  });
  for (const scene::Field field : kCubicFields) {
    expectFirstHits({noise, {0.45}, field}, "white noise", 3);
    expectFirstHits({quantized<std::uint8_t>(noise, 0, 4, 1.0), {5.0}, field}, "white noise of five values",
                    3);
  }
}

TEST(CubicCaster, ReadsEveryTypeOfVoxels) {
  const Grid gyroid = test::phantomGrid("gyroid", 24);
  for (const scene::Field field : kCubicFields) {
    expectFirstHits({quantized<std::int8_t>(gyroid, -120, 120, 1.0), {10.5}, field}, "int8", 2);
    expectFirstHits({quantized<std::uint8_t>(gyroid, 0, 255, 2.0), {200.0}, field}, "uint8", 2);
    expectFirstHits({quantized<std::int16_t>(gyroid, -30000, 30000, -0.5), {100.0}, field}, "int16, falling",
                    2);
    expectFirstHits({quantized<std::uint16_t>(gyroid, 0, 65535, 1.0), {30000.0}, field}, "uint16", 2);
  }
}

TEST(CubicCaster, KeepsSmallPartsOfLargeValuesAndHugeOrTinyOnes) {
  const Grid gyroid = test::phantomGrid("gyroid", 24);
  for (const scene::Field field : kCubicFields) {
    for (const float offset : {1e6f, -1e6f}) {
      const Grid far =
          changed(gyroid, [&](glm::ivec3, double v) { return offset + static_cast<float>(16.0 * v); });
      expectFirstHits({far, {static_cast<double>(offset) + 1.0}, field}, "1e6 + small", 2);
    }
    for (const double factor : {1e25, 1e-25}) {
      const Grid scaled =
          changed(gyroid, [&](glm::ivec3, double v) { return static_cast<float>(factor * v); });
      expectFirstHits({scaled, {0.1 * factor}, field}, "far from 1", 2);
    }
  }
}

TEST(CubicCaster, GapsHoldNoSurface) {
  for (const scene::Field field : kCubicFields)
    expectFirstHits({withHoles(test::phantomGrid("gyroid", 32)), {0.05}, field}, "holes", 4);
}

TEST(CubicCaster, FollowsFourSurfacesAtOnce) {
  for (const scene::Field field : kCubicFields) {
    expectFirstHits({test::phantomGrid("gyroid", 24), {0.1, -0.4, 0.6, 0.12}, field}, "four surfaces", 2);
    expectFirstHits({test::phantomGrid("noise", 20), {0.0, 0.1, -0.1}, field}, "three surfaces of noise", 2);
  }
}

// Axes of two voxels have no sample that is not at the border.
TEST(CubicCaster, SamplesRepeatBeyondTheBorder) {
  for (const scene::Field field : kCubicFields) {
    const Grid thin = test::gridOfVoxels(test::unitGeometry({60, 50, 2}), [](glm::dvec3 p) {
      return std::sin(0.3 * p.y) + std::cos(0.4 * p.x) + 0.5 * p.z;
    });
    expectFirstHits({thin, {0.0}, field}, "two voxels", 3);
  }
}

// Along a ray: the crossings behind one another are those of the field, in their order.
TEST(CubicCaster, GoesOnBehindACrossing) {
  const std::vector<float> open(static_cast<std::size_t>(kSize.x * kSize.y), 0.0f);
  for (const scene::Field field : kCubicFields) {
    const Prepared volume(test::phantomGrid("gyroid", 24), {0.1, -0.4}, field);
    const PictureRays rays = view(0, volume.grid().dims());
    for (const TracerTarget target : targets()) {
      const SurfaceCaster caster = volume.caster(target);
      CrossingImage before = cast(caster, rays);
      int compared = 0, differing = 0;
      for (int layer = 1; layer < 5; ++layer) {
        CrossingImage next = before;
        caster.castBehind(rays, {before, open}, next);
        for (std::size_t i = 0; i < next.points.size(); ++i) {
          const float from = before.points[i].w, to = next.points[i].w;
          if (from < 0.0f) {
            EXPECT_LT(to, 0.0f);
            continue;
          }
          if (to >= 0.0f && to - from < 0.05f) continue;  // closer than the reference's step
          Ray ray = rayOf(
              rays,
              glm::dvec2(i % static_cast<std::size_t>(kSize.x), i / static_cast<std::size_t>(kSize.x)) + 0.5);
          ray.tMinimum = static_cast<double>(from) + 0.01;
          double least = std::numeric_limits<double>::infinity();
          for (const double isovalue : volume.isovalues)
            if (const auto hit = volume.firstHit(isovalue, ray).hit) least = std::min(least, hit->t);
          ++compared;
          differing += std::isinf(least) != (to < 0.0f) ||
                       (!std::isinf(least) && std::fabs(least - static_cast<double>(to)) > 0.02);
        }
        before = std::move(next);
      }
      EXPECT_GT(compared, 4000);
      EXPECT_LT(differing, compared / 2000);  // rays that graze
    }
  }
}

// What a crossing says of its own error is the field there less the isovalue, in texels.
TEST(CubicCaster, ValueErrorsAreThoseOfTheField) {
  const Prepared volume(test::phantomGrid("gyroid", 32), {0.1}, scene::Field::cubic);
  const double texel = std::ldexp(1.0, exponentOf(volume.grid().minimum(), volume.grid().maximum()));
  for (const TracerTarget target : targets()) {
    const CrossingImage picture = cast(volume.caster(target), view(0, volume.grid().dims()));
    int hits = 0;
    for (std::size_t i = 0; i < picture.points.size(); ++i) {
      if (picture.points[i].w < 0.0f) continue;
      ++hits;
      const double value = sampleCubic(volume.grid(), glm::dvec3(picture.points[i])).value - 0.1;
      EXPECT_NEAR(static_cast<double>(picture.infos[i].x), std::fabs(value) / texel, 1e-6);
      EXPECT_LT(std::fabs(value), 1e-4);
    }
    EXPECT_GT(hits, 1000);
  }
}

// Ridges that rise above the isovalue by a sixth of a rounding of their samples; those before and behind lose
// one in a cell's bounds.
TEST(CubicCaster, LosesNoHitWhereACellsBoundsAreARoundingNarrowerThanTheField) {
  struct Ridge {
    float before, top, behind;
  };
  for (const Ridge& ridge : {Ridge{-0x1.b24ce4p+0f, 0x1.5b1e2p-1f, -0x1.03ef5ap+0f},
                             Ridge{-0x1.57c494p+0f, 0x1.2e31d8p-1f, -0x1.049f1ap+0f},
                             Ridge{-0x1.e91eb4p+0f, 0x1.915768p-1f, -0x1.39901ap+0f}}) {
    const Prepared volume(
        test::gridOfVoxels(test::unitGeometry(glm::ivec3(12)),
                           [&](glm::dvec3 p) {
                             return p.x == 6.0 ? ridge.top : p.x < 6.0 ? ridge.before : ridge.behind;
                           }),
        {0.0}, scene::Field::cubic);
    const PictureRays rays = view(0, volume.grid().dims());
    for (const TracerTarget target : targets()) {
      const CrossingImage picture = cast(volume.caster(target), rays);
      const auto width = static_cast<std::size_t>(kSize.x);
      int hits = 0, lost = 0;
      for (std::size_t i = 0; i < picture.points.size(); ++i) {
        const CubicHit expected = volume.firstHit(0.0, rayOf(rays, glm::dvec2(i % width, i / width) + 0.5));
        if (!expected.hit || !expected.certain) continue;
        ++hits;
        lost += picture.points[i].w < 0.0f;
      }
      EXPECT_GT(hits, 400);
      EXPECT_EQ(lost, 0);
    }
  }
}

}  // namespace
}  // namespace isolux::volume
