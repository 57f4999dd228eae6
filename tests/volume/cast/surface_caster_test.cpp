// Every test runs on every target of this machine (caster_checks.h). Cubic fields: cubic_caster_test.cpp.
#include "volume/cast/surface_caster.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/volumes.h"
#include "tests/volume/cast/caster_checks.h"
#include "volume/field/reconstruct.h"
#include "volume/hit/exact_hit.h"

namespace isolux::volume {
namespace {

using namespace test::casting;

TEST(SurfaceCaster, FindsWhatTheReferenceFinds) {
  expectFirstHits({test::phantomGrid("gyroid", 40), {0.1}}, "gyroid", 8);
  expectFirstHits({test::phantomGrid("noise", 33), {0.0}}, "noise", 8);
  expectFirstHits({test::phantomGrid("sheet", 48), {0.0}}, "sheet", 4);
}

TEST(SurfaceCaster, ReadsEveryTypeOfVoxels) {
  const Grid gyroid = test::phantomGrid("gyroid", 32);
  expectFirstHits({quantized<std::int8_t>(gyroid, -120, 120, 1.0), {10.5}}, "int8", 4);
  expectFirstHits({quantized<std::uint8_t>(gyroid, 0, 255, 2.0), {200.0}}, "uint8", 4);
  expectFirstHits({quantized<std::int16_t>(gyroid, -30000, 30000, -0.5), {100.0}}, "int16, falling", 4);
  expectFirstHits({quantized<std::uint16_t>(gyroid, 0, 65535, 1.0), {30000.0}}, "uint16", 4);
}

TEST(SurfaceCaster, KeepsSmallPartsOfLargeValuesAndHugeOrTinyOnes) {
  const Grid gyroid = test::phantomGrid("gyroid", 32);
  for (const float offset : {1e6f, -1e6f}) {
    const Grid far =
        changed(gyroid, [&](glm::ivec3, double v) { return offset + static_cast<float>(16.0 * v); });
    expectFirstHits({far, {static_cast<double>(offset) + 1.0}}, "1e6 + small", 3);
  }
  for (const double factor : {1e25, 1e-25}) {
    const Grid scaled = changed(gyroid, [&](glm::ivec3, double v) { return static_cast<float>(factor * v); });
    expectFirstHits({scaled, {0.1 * factor}}, "far from 1", 3);
  }
}

TEST(SurfaceCaster, GapsHoldNoSurface) {
  expectFirstHits({withHoles(test::phantomGrid("gyroid", 32)), {0.05}}, "holes", 8);
}

// The cells beside what stands for no value hold no surface, however far away that is, on either side.
TEST(SurfaceCaster, AFillHoldsNoSurface) {
  const auto ball = [](double sign, double fill) {
    return test::gridOfVoxels(test::unitGeometry(glm::ivec3(48)), [=](glm::dvec3 p) {
      const double r = glm::distance(p, glm::dvec3(23.3, 23.9, 23.1));
      return sign * (fill < 0.0 && r > 18.0 ? fill : 15.0 - r);
    });
  };
  for (const double sign : {1.0, -1.0})
    for (const double fill :
         {-1e9, -1e15, -1e20, -1e30, static_cast<double>(std::numeric_limits<float>::lowest())}) {
      const scene::Inside inside = sign > 0.0 ? scene::Inside::above : scene::Inside::below;
      const Prepared filled(ball(sign, fill), {0.0}, scene::Field::trilinear, {}, inside),
          plain(ball(sign, 0.0), {0.0}, scene::Field::trilinear, {}, inside);
      for (const TracerTarget target : targets()) {
        int hits = 0, differing = 0;
        for (int k = 0; k < 4; ++k) {
          const PictureRays rays = view(k, glm::ivec3(48));
          const CrossingImage seen = cast(filled.caster(target), rays),
                              expected = cast(plain.caster(target), rays);
          for (std::size_t i = 0; i < seen.points.size(); ++i) {
            const glm::vec4 a = seen.points[i], b = expected.points[i];
            hits += b.w >= 0.0f;
            differing += (a.w < 0.0f) != (b.w < 0.0f) ||
                         (a.w >= 0.0f && glm::distance(glm::vec3(a), glm::vec3(b)) > 1e-3f);
          }
        }
        EXPECT_GT(hits, 2000);
        EXPECT_EQ(differing, 0) << sign * fill;
      }
    }
}

TEST(SurfaceCaster, FollowsFourSurfacesAtOnce) {
  expectFirstHits({test::phantomGrid("gyroid", 32), {0.1, -0.4, 0.6, 0.12}}, "four surfaces", 8);
  expectFirstHits({test::phantomGrid("noise", 24), {0.0, 0.3, -0.3}}, "three surfaces of noise", 8);
}

// Along a ray: the crossings behind one another are those of the field, in their order.
TEST(SurfaceCaster, GoesOnBehindACrossing) {
  const Prepared volume(test::phantomGrid("gyroid", 32), {0.1, -0.4});
  const std::vector<float> open(static_cast<std::size_t>(kSize.x * kSize.y), 0.0f);
  for (const TracerTarget target : targets()) {
    const SurfaceCaster caster = volume.caster(target);
    const PictureRays rays = view(0, volume.grid().dims());
    CrossingImage before = cast(caster, rays);
    int compared = 0, behind = 0;
    for (int layer = 1; layer < 6; ++layer) {
      CrossingImage next = before;
      caster.castBehind(rays, {before, open}, next);
      for (std::size_t i = 0; i < next.points.size(); ++i) {
        if (before.points[i].w < 0.0f) {
          EXPECT_LT(next.points[i].w, 0.0f);
          continue;
        }
        // The next by the reference: the least root of either surface behind.
        const Ray ray = rayOf(
            rays,
            glm::dvec2(i % static_cast<std::size_t>(kSize.x), i / static_cast<std::size_t>(kSize.x)) + 0.5);
        double least = std::numeric_limits<double>::infinity();
        for (const double isovalue : volume.isovalues)
          if (const auto hit =
                  firstHit(volume.grid(), volume.blocks(), isovalue,
                           {ray.origin, ray.direction, static_cast<double>(before.points[i].w) + 0.01}))
            least = std::min(least, hit->t);
        // Pairs of crossings closer than the step of the reference are not compared.
        const bool close = next.points[i].w >= 0.0f && next.points[i].w - before.points[i].w < 0.05f;
        if (close) continue;
        ++compared;
        if (std::isinf(least) != (next.points[i].w < 0.0f) ||
            (!std::isinf(least) && std::fabs(least - static_cast<double>(next.points[i].w)) > 0.02))
          ++behind;
      }
      before = std::move(next);
    }
    EXPECT_GT(compared, 5000);
    EXPECT_LT(behind, compared / 2000);  // rays that graze
  }
}

TEST(SurfaceCaster, EndsWhereAPixelIsCovered) {
  const Prepared volume(test::phantomGrid("gyroid", 32), {0.1});
  const SurfaceCaster caster = volume.caster(TracerTarget::automatic);
  const PictureRays rays = view(0, volume.grid().dims());
  const CrossingImage first = cast(caster, rays);
  std::vector<float> covered(first.points.size(), 0.0f);
  for (std::size_t i = 0; i < covered.size(); i += 2) covered[i] = 1.0f;
  CrossingImage next = first;
  caster.castBehind(rays, {first, covered}, next);
  int hits = 0;
  for (std::size_t i = 0; i < covered.size(); ++i) {
    if (i % 2 == 0) {
      EXPECT_LT(next.points[i].w, 0.0f);
    }
    hits += next.points[i].w >= 0.0f;
  }
  EXPECT_GT(hits, 500);
}

// A part of a picture is the picture cut out, bit for bit.
TEST(SurfaceCaster, APartOfAPictureIsCutOut) {
  const Prepared volume(test::phantomGrid("gyroid", 32), {0.1});
  const SurfaceCaster caster = volume.caster(TracerTarget::automatic);
  PictureRays rays = view(2, volume.grid().dims());
  const CrossingImage whole = cast(caster, rays);
  rays.origin = {32, 20};
  const glm::ivec2 size(40, 30);
  CrossingImage part(size);
  caster.castAll(rays, part);
  int differing = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const auto of = static_cast<std::size_t>((y + 20) * kSize.x + x + 32);
      const glm::vec4 a = part.points[static_cast<std::size_t>(y * size.x + x)], b = whole.points[of];
      differing += (a.w < 0.0f) != (b.w < 0.0f) || glm::distance(glm::vec3(a), glm::vec3(b)) > 1e-3f;
    }
  EXPECT_EQ(differing, 0);
}

// The shadow ray of shadow.frag.glsl in double precision: whether the way from the hit to the light is free.
bool isLit(const Prepared& volume, const glm::dvec3& point, const glm::dvec3& ray, const glm::dvec3& normal,
           const glm::dvec3& light) {
  const double facing = glm::dot(normal, light);
  if (facing <= 0.0) return false;
  const glm::dvec3 origin = point - 1e-3 * ray;
  const auto met = [&](const glm::dvec3& from, const glm::dvec3& direction) {
    Ray way;
    way.origin = from;
    way.direction = direction;
    return volume.firstHit(volume.isovalues[0], way).hit;
  };
  double offset = 0.02 + 0.4 * (1.0 - facing) * (1.0 - facing);
  if (const auto near = met(origin, normal); near && near->t < offset) offset = 0.5 * near->t;
  return !met(origin + offset * normal, light);
}

TEST(SurfaceCaster, ShadowsAreThoseOfTheReference) {
  const glm::dvec3 light = glm::normalize(glm::dvec3(0.5, -0.6, 0.7));
  for (const auto& [name, field] :
       {std::pair{"gyroid", scene::Field::trilinear}, std::pair{"torus", scene::Field::trilinear},
        std::pair{"gyroid", scene::Field::cubic_interpolating}, std::pair{"torus", scene::Field::cubic}}) {
    const Prepared volume(test::phantomGrid(name, 32), {0.1}, field);
    for (const TracerTarget target : targets()) {
      const SurfaceCaster caster = volume.caster(target);
      int lit = 0, dark = 0, differing = 0;
      for (int k = 0; k < 8; ++k) {
        const PictureRays rays = view(k, volume.grid().dims());
        const CrossingImage hits = cast(caster, rays);
        std::vector<glm::vec4> gradients(hits.points.size());
        for (std::size_t i = 0; i < gradients.size(); ++i)
          if (hits.points[i].w >= 0.0f)
            gradients[i] = glm::vec4(sampleCubic(volume.grid(), glm::dvec3(hits.points[i])).gradient, 1.0);
        ShadowImage shadow;
        caster.castShadows({.rays = rays,
                            .right = rays.right,
                            .up = rays.up,
                            .forward = rays.forward,
                            .outward = -1.0f,
                            .light = light,
                            .opaque = 1},
                           hits, gradients, shadow);
        for (std::size_t i = 0; i < gradients.size(); ++i) {
          if (hits.points[i].w < 0.0f) {
            EXPECT_EQ(shadow.lit[i], 0);
            continue;
          }
          const glm::dvec2 fragment(i % static_cast<std::size_t>(kSize.x),
                                    i / static_cast<std::size_t>(kSize.x));
          const glm::dvec3 ray = rayOf(rays, fragment + 0.5).direction;
          const int known = static_cast<int>(hits.infos[i].y);
          glm::dvec3 normal = -glm::normalize(glm::dvec3(gradients[i]));
          if ((known & 4) == 0) normal = -normal;  // f falls behind: the inner side is seen
          const double away = glm::dot(normal, ray);
          if (away > 0.0) normal = glm::normalize(normal - away * ray);
          const bool expected = isLit(volume, glm::dvec3(hits.points[i]), ray, normal, light);
          (expected ? lit : dark) += 1;
          differing += expected != (shadow.lit[i] != 0);
        }
      }
      EXPECT_GT(lit, 1000) << name;
      EXPECT_GT(dark, 1000) << name;
      EXPECT_LE(differing, (lit + dark) / 500) << name;  // rays that graze
    }
  }
}

// Images that show another view, and are drawn over where that and this one hit, are those of new images.
TEST(SurfaceCaster, LeavesNothingOfTheViewBefore) {
  const Prepared volume(test::phantomGrid("torus", 32), {0.0});
  for (const TracerTarget target : targets()) {
    const SurfaceCaster caster = volume.caster(target);
    CrossingImage kept(kSize), behind(kSize);
    const std::vector<float> open(kept.points.size(), 0.0f);
    for (int k = 0; k < 12; ++k) {
      PictureRays rays = view(k, volume.grid().dims());
      rays.eye += static_cast<float>(k % 5) * rays.right;
      caster.castAll(rays, kept);
      const CrossingImage fresh = cast(caster, rays);
      EXPECT_TRUE(kept.points == fresh.points && kept.infos == fresh.infos);
      EXPECT_EQ(kept.area.rectangles(), fresh.area.rectangles());
      caster.castBehind(rays, {kept, open}, behind);
      CrossingImage freshBehind(kSize);
      caster.castBehind(rays, {kept, open}, freshBehind);
      EXPECT_TRUE(behind.points == freshBehind.points && behind.infos == freshBehind.infos);
    }
  }
}

// All crossings lie in the area, and it is no larger than strips of them need.
TEST(SurfaceCaster, KnowsWhereTheCrossingsAre) {
  const Prepared volume(test::phantomGrid("torus", 32), {0.0});
  const SurfaceCaster caster = volume.caster(TracerTarget::automatic);
  for (int k = 0; k < 8; ++k) {
    const CrossingImage picture = cast(caster, view(k, volume.grid().dims()));
    PictureArea expected(kSize);
    for (int y = 0; y < kSize.y; ++y)
      for (int x = 0; x < kSize.x; ++x)
        if (picture.points[static_cast<std::size_t>(y * kSize.x + x)].w >= 0.0f) expected.add(y, x, x + 1);
    EXPECT_EQ(picture.area.rectangles(), expected.rectangles());
  }
}

}  // namespace
}  // namespace isolux::volume
