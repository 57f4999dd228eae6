#include <algorithm>

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "tests/support/hidden_balls.h"
#include "tests/volume/cast/caster_checks.h"
#include "volume/visible/voxel_mask.h"

namespace isolux::volume {
namespace {

using test::casting::cast;
using test::casting::expectFirstHits;
using test::casting::kSize;
using test::casting::Prepared;
using test::casting::targets;
using test::casting::view;

constexpr scene::Field kFields[] = {scene::Field::trilinear, scene::Field::cubic};

struct Balls {
  Balls(scene::Field field, double sign, std::vector<double> values = {0.0})
      : hidden(test::hiddenOfBalls(test::pieceBalls())),
        all(test::gridOfBalls(test::pieceBalls(), true, sign), values, field,
            std::vector<const VoxelMask*>(values.size(), &hidden),
            sign > 0.0 ? scene::Inside::above : scene::Inside::below),
        shown(test::gridOfBalls(test::pieceBalls(), false, sign), values, field) {}

  const VoxelMask hidden;
  const Prepared all, shown;
};

// How many pixels differ in any bit.
int differing(const CrossingImage& a, const CrossingImage& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.points.size(); ++i)
    count += a.points[i] != b.points[i] || a.infos[i] != b.infos[i];
  return count;
}

TEST(HiddenCaster, HitsAreThoseOfAVolumeWithoutTheHiddenBalls) {
  for (const scene::Field field : kFields)
    for (const double sign : {1.0, -1.0}) {
      const Balls balls(field, sign);
      for (int k = 0; k < 8; ++k) {
        const PictureRays rays = view(k, glm::ivec3(48));
        for (const TracerTarget target : targets()) {
          const CrossingImage hits = cast(balls.all.caster(target), rays),
                              expected = cast(balls.shown.caster(target), rays);
          EXPECT_EQ(differing(hits, expected), 0) << k << ' ' << sign;
        }
      }
    }
}

TEST(HiddenCaster, GoesOnBehindACrossingAndMakesShadowsAsWithoutThem) {
  const std::vector<float> open(static_cast<std::size_t>(kSize.x * kSize.y), 0.0f);
  for (const scene::Field field : kFields) {
    const Balls balls(field, 1.0);
    for (int k = 0; k < 4; ++k) {
      const PictureRays rays = view(k, glm::ivec3(48));
      const SurfaceCaster all = balls.all.caster(TracerTarget::automatic),
                          shown = balls.shown.caster(TracerTarget::automatic);
      CrossingImage front = cast(shown, rays);
      const std::vector<glm::vec4> gradients(front.points.size(), glm::vec4(-rays.forward, 1.0f));
      const ShadowRays shadow{.rays = rays,
                              .right = glm::normalize(rays.right),
                              .up = glm::normalize(rays.up),
                              .forward = glm::normalize(rays.forward),
                              .light = glm::normalize(glm::vec3(0.3f, 0.2f, 1.0f) - rays.forward)};
      ShadowImage lit, expectedLit;
      all.castShadows(shadow, front, gradients, lit);
      shown.castShadows(shadow, front, gradients, expectedLit);
      EXPECT_EQ(lit.lit, expectedLit.lit) << k;
      for (int layer = 0; layer < 3; ++layer) {
        CrossingImage behind = front, expected = front;
        all.castBehind(rays, {front, open}, behind);
        shown.castBehind(rays, {front, open}, expected);
        EXPECT_EQ(differing(behind, expected), 0) << k << ' ' << layer;
        front = std::move(expected);
      }
    }
  }
}

// One surface has hidden pieces, another crosses the same boxes with all of its own.
TEST(HiddenCaster, HidesPiecesOfOneOfTwoSurfaces) {
  const VoxelMask hidden = test::hiddenOfBalls(test::pieceBalls());
  for (const scene::Field field : kFields)
    expectFirstHits({test::gridOfBalls(test::pieceBalls(), true), {0.0, 0.9}, field, {&hidden, nullptr}},
                    "one of two surfaces", 8);
}

TEST(HiddenCaster, InCellsOfTwoPiecesHitsAreOfTheShownOne) {
  const VoxelMask hidden = test::SplitCells::hidden();
  for (const double sign : {1.0, -1.0})
    expectFirstHits({test::SplitCells::grid(sign),
                     {0.0},
                     scene::Field::trilinear,
                     {&hidden},
                     sign > 0.0 ? scene::Inside::above : scene::Inside::below},
                    "split cells", 12);
}

// Two slabs, apart by samples that the spline passes over: what is seen ends within its inside.
TEST(HiddenCaster, WhereASplineBridgesAGapTheHiddenPieceIsLeftOut) {
  constexpr glm::ivec3 dims(32, 32, 24);
  VoxelMask hidden(dims);
  for (int z = 0; z < dims.z; ++z)
    for (int y = 8; y < 24; ++y) hidden.hide(0, 15, y, z);
  for (const double sign : {1.0, -1.0})
    expectFirstHits({test::gridOfVoxels(test::unitGeometry(dims),
                                        [&](glm::dvec3 p) {
                                          const double depth = std::abs(p.y - 15.5) > 8.0   ? -10.0
                                                               : std::abs(p.x - 15.5) < 1.0 ? -0.1
                                                                                            : 10.0;
                                          return sign * depth;
                                        }),
                     {0.0},
                     scene::Field::cubic,
                     {&hidden},
                     sign > 0.0 ? scene::Inside::above : scene::Inside::below},
                    "bridged", 5);
}

// An interpolating spline overshoots between eight voxels just outside: a stray surface, without an inside
// voxel around.
TEST(HiddenCaster, StraysOfASplineAreHiddenWhereThePiecesShownAreNamed) {
  constexpr glm::ivec3 dims(40, 20, 20);
  const auto strays = [&](bool hides) {
    const VoxelMask hidden(dims, hides);
    const Prepared volume(
        test::gridOfVoxels(test::unitGeometry(dims),
                           [](glm::dvec3 p) {
                             if (glm::distance(p, glm::dvec3(10.0)) < 6.0) return 10.0;
                             const glm::dvec3 apart = glm::abs(p - glm::dvec3(29.5, 9.5, 9.5));
                             return std::max({apart.x, apart.y, apart.z}) < 1.0 ? -0.05 : -10.0;
                           }),
        {0.0}, scene::Field::cubic_interpolating, {&hidden});
    std::vector<int> counts;
    for (const TracerTarget target : targets()) {
      int ofBall = 0, ofStray = 0;
      for (int k = 0; k < 6; ++k)
        for (const glm::vec4& p : cast(volume.caster(target), view(k, dims)).points)
          if (p.w >= 0.0f) ++(p.x < 20.0f ? ofBall : ofStray);
      EXPECT_GT(ofBall, 500);
      counts.push_back(ofStray);
    }
    return counts;
  };
  for (const int count : strays(false)) EXPECT_GT(count, 20);
  for (const int count : strays(true)) EXPECT_EQ(count, 0);
}

TEST(HiddenCaster, StoredValuesThatFallWithTheData) {
  const std::vector<test::PieceBall> balls = test::pieceBalls();
  const Grid grid = test::gridOfBalls(balls, true);
  const Grid falling = test::casting::quantized<std::int16_t>(grid, 1000.0, 0.0, -1.0);  // 3 - stored
  const VoxelMask hidden = test::hiddenOfBalls(balls);
  const Prepared volume(falling, {3.0 - 499.5}, scene::Field::trilinear, {&hidden});
  expectFirstHits(volume, "slope -1", 4);
}

}  // namespace
}  // namespace isolux::volume
