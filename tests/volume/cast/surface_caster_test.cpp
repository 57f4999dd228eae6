// Every test runs on every target of this machine. A hit or miss that differs from the double-precision
// reference is accepted only where the reference itself changes its answer within the rounding of float: for
// a ray a hundredth of a pixel beside it.
#include "volume/cast/surface_caster.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/random.h"
#include "tests/support/volumes.h"
#include "volume/field/reconstruct.h"
#include "volume/hit/cell_walk.h"
#include "volume/hit/exact_hit.h"
#include "volume/skip/box_bounds.h"
#include "volume/skip/min_max_blocks.h"

namespace isolux::volume {
namespace {

constexpr glm::ivec2 kSize{90, 71};  // no multiple of a packet

std::vector<TracerTarget> targets() {
  std::vector<TracerTarget> list = IsosurfaceTracer::availableTargets();
  std::erase(list, TracerTarget::scalar);
  return list;
}

// What a caster needs of a grid.
struct Prepared {
  Prepared(Grid made, std::vector<double> values)
      : grid(std::move(made)),
        blocks(grid, 8, progress),
        boxes(grid, progress),
        isovalues(std::move(values)) {
    std::vector<float> stored;
    for (const double value : isovalues) stored.push_back(static_cast<float>(grid.storedOfValue(value)));
    for (const float value : stored) {
      std::vector<std::uint8_t> own;
      blocks.activeBlocks(value, own);
      flags.resize(own.size());
      for (std::size_t i = 0; i < own.size(); ++i) flags[i] |= own[i];
    }
    boxes.masks(stored, flags, masks);
  }
  SurfaceCaster caster(TracerTarget target) const {
    std::vector<double> stored;
    for (const double value : isovalues) stored.push_back(grid.storedOfValue(value));
    return {grid, stored, blocks.dims(), masks, target};
  }

  base::Progress progress;
  Grid grid;
  MinMaxBlocks blocks;
  BoxBounds boxes;
  std::vector<double> isovalues;
  std::vector<std::uint8_t> flags;
  std::vector<std::uint64_t> masks;
};

// View `k` of the middle of a volume of voxels of 1 mm: outside, close by and inside, and both projections.
PictureRays view(int k, glm::ivec3 dims) {
  const glm::dvec3 middle = 0.5 * glm::dvec3(dims - 1);
  const double size = glm::length(glm::dvec3(dims));
  const double azimuth = 2.399963 * k, height = -0.9 + 1.8 * ((k * 7) % 20) / 19.0;
  const glm::dvec3 back(std::cos(azimuth) * std::sqrt(1.0 - height * height),
                        std::sin(azimuth) * std::sqrt(1.0 - height * height), height);
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0.1, 0.2, 1.0), back));
  PictureRays rays;
  rays.orthographic = k % 4 == 1;
  const double distance = rays.orthographic ? size : size * (k % 4 == 3 ? 0.12 : k % 4 == 2 ? 0.6 : 1.6);
  rays.eye = middle + distance * back;
  rays.right = right;
  rays.up = glm::cross(back, right);
  rays.forward = -back;
  const double half = rays.orthographic ? 0.45 * size : k % 4 == 3 ? 0.84 : 0.36;
  rays.halfExtent = {static_cast<float>(half * kSize.x / kSize.y), static_cast<float>(half)};
  rays.picture = kSize;
  return rays;
}

Ray rayOf(const PictureRays& rays, glm::dvec2 fragment) {
  const glm::dvec2 plane = (fragment / glm::dvec2(rays.picture) * 2.0 - 1.0) * glm::dvec2(rays.halfExtent);
  const glm::dvec3 offset = plane.x * glm::dvec3(rays.right) + plane.y * glm::dvec3(rays.up);
  Ray ray;
  ray.origin = glm::dvec3(rays.eye) + (rays.orthographic ? offset : glm::dvec3(0.0));
  ray.direction = rays.orthographic
                      ? glm::dvec3(rays.forward)
                      : (glm::dvec3(rays.forward) + offset) / std::sqrt(1.0 + glm::dot(plane, plane));
  return ray;
}

CrossingImage cast(const SurfaceCaster& caster, const PictureRays& rays) {
  CrossingImage picture(kSize);
  caster.castAll(rays, picture);
  return picture;
}

// The nearest first crossing of the surfaces, and which.
struct Expected {
  double t = std::numeric_limits<double>::infinity();
  glm::dvec3 voxel{0.0};
  int surface = 0;
  bool rises = false;
};
Expected expectedOf(const Prepared& volume, const Ray& ray) {
  Expected nearest;
  for (std::size_t k = 0; k < volume.isovalues.size(); ++k) {
    const auto hit = firstHit(volume.grid, volume.blocks, volume.isovalues[k], ray.origin, ray.direction);
    if (hit && hit->t < nearest.t) nearest = {hit->t, hit->voxel, static_cast<int>(k), hit->entering};
  }
  return nearest;
}

void expectFirstHits(const Prepared& volume, const char* name, int views) {
  for (const TracerTarget target : targets()) {
    const SurfaceCaster caster = volume.caster(target);
    int hits = 0, undecided = 0;
    for (int k = 0; k < views; ++k) {
      const PictureRays rays = view(k, volume.grid.dims());
      const CrossingImage picture = cast(caster, rays);
      for (int i = 0; i < kSize.x * kSize.y; ++i) {
        const glm::vec4 point = picture.points[static_cast<std::size_t>(i)];
        const glm::vec2 info = picture.infos[static_cast<std::size_t>(i)];
        const glm::dvec2 fragment(i % kSize.x + 0.5, i / kSize.x + 0.5);
        const auto agrees = [&](glm::dvec2 at) {
          const Expected expected = expectedOf(volume, rayOf(rays, at));
          if (std::isinf(expected.t)) return point.w < 0.0f;
          const int known = static_cast<int>(info.y);
          return point.w >= 0.0f && glm::distance(glm::dvec3(point), expected.voxel) < 0.02 &&
                 (known & 3) == expected.surface &&
                 ((known >> 2 >> expected.surface & 1) != 0) ==
                     (expected.rises == (volume.grid.slope() > 0.0));
        };
        hits += point.w >= 0.0f;
        if (agrees(fragment)) continue;
        bool beside = false;
        for (const glm::dvec2& step :
             {glm::dvec2(1, 0), glm::dvec2(-1, 0), glm::dvec2(0, 1), glm::dvec2(0, -1)})
          beside = beside || agrees(fragment + 0.01 * step);
        // A crossing where the ray enters the volume lies on either side of its border by rounding.
        const glm::dvec3 at = expectedOf(volume, rayOf(rays, fragment)).voxel;
        const glm::dvec3 last(volume.grid.dims() - 1);
        for (int axis = 0; axis < 3; ++axis)
          beside = beside || std::min(at[axis], last[axis] - at[axis]) < 1e-4;
        undecided += beside;
        EXPECT_TRUE(beside) << name << ", view " << k << ", pixel " << i % kSize.x << ' ' << i / kSize.x;
        if (::testing::Test::HasFailure()) return;
      }
    }
    EXPECT_GT(hits, 300 * views) << name;
    EXPECT_LT(undecided, 1 + hits / 1000) << name;
  }
}

template <class T>
Grid quantized(const Grid& grid, double from, double to, double slope) {
  std::vector<T> voxels;
  const glm::ivec3 dims = grid.dims();
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x)
        voxels.push_back(
            static_cast<T>(std::lround(from + (to - from) * (grid.value(x, y, z) - grid.minimum()) /
                                                  (grid.maximum() - grid.minimum()))));
  return Grid(grid.geometry(), VoxelArray(std::move(voxels)), slope, 3.0);
}

Grid changed(const Grid& grid, const std::function<float(glm::ivec3, double)>& change) {
  std::vector<float> voxels;
  const glm::ivec3 dims = grid.dims();
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) voxels.push_back(change({x, y, z}, grid.value(x, y, z)));
  return Grid(grid.geometry(), std::move(voxels));
}

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
  const Grid gyroid = test::phantomGrid("gyroid", 32);
  const Grid holes = changed(gyroid, [](glm::ivec3 p, double v) {
    return base::hash64(static_cast<std::uint64_t>((p.z / 3 * 97 + p.y / 3) * 97 + p.x / 3)) % 7 == 0
               ? std::numeric_limits<float>::quiet_NaN()
               : static_cast<float>(v);
  });
  expectFirstHits({holes, {0.05}}, "holes", 8);
}

TEST(SurfaceCaster, FollowsFourSurfacesAtOnce) {
  expectFirstHits({test::phantomGrid("gyroid", 32), {0.1, -0.4, 0.6, 0.12}}, "four surfaces", 8);
  expectFirstHits({test::phantomGrid("noise", 24), {0.0, 0.3, -0.3}}, "three surfaces of noise", 8);
}

// Along a ray: the crossings behind one another are those of the field, in their order.
TEST(SurfaceCaster, GoesOnBehindACrossing) {
  const Prepared volume({test::phantomGrid("gyroid", 32), {0.1, -0.4}});
  const std::vector<float> open(static_cast<std::size_t>(kSize.x * kSize.y), 0.0f);
  for (const TracerTarget target : targets()) {
    const SurfaceCaster caster = volume.caster(target);
    const PictureRays rays = view(0, volume.grid.dims());
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
          if (const auto hit = firstHit(volume.grid, volume.blocks, isovalue, ray.origin, ray.direction,
                                        static_cast<double>(before.points[i].w) + 0.01))
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
  const Prepared volume({test::phantomGrid("gyroid", 32), {0.1}});
  const SurfaceCaster caster = volume.caster(TracerTarget::automatic);
  const PictureRays rays = view(0, volume.grid.dims());
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
  const Prepared volume({test::phantomGrid("gyroid", 32), {0.1}});
  const SurfaceCaster caster = volume.caster(TracerTarget::automatic);
  PictureRays rays = view(2, volume.grid.dims());
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
    return firstHit(volume.grid, volume.blocks, volume.isovalues[0], from, direction);
  };
  double offset = 0.02 + 0.4 * (1.0 - facing) * (1.0 - facing);
  if (const auto near = met(origin, normal); near && near->t < offset) offset = 0.5 * near->t;
  return !met(origin + offset * normal, light);
}

TEST(SurfaceCaster, ShadowsAreThoseOfTheReference) {
  const glm::dvec3 light = glm::normalize(glm::dvec3(0.5, -0.6, 0.7));
  for (const char* name : {"gyroid", "torus"}) {
    const Prepared volume({test::phantomGrid(name, 32), {0.1}});
    for (const TracerTarget target : targets()) {
      const SurfaceCaster caster = volume.caster(target);
      int lit = 0, dark = 0, differing = 0;
      for (int k = 0; k < 8; ++k) {
        const PictureRays rays = view(k, volume.grid.dims());
        const CrossingImage hits = cast(caster, rays);
        std::vector<glm::vec4> gradients(hits.points.size());
        for (std::size_t i = 0; i < gradients.size(); ++i)
          if (hits.points[i].w >= 0.0f)
            gradients[i] = glm::vec4(sampleCubic(volume.grid, glm::dvec3(hits.points[i])).gradient, 1.0);
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
  const Prepared volume({test::phantomGrid("torus", 32), {0.0}});
  for (const TracerTarget target : targets()) {
    const SurfaceCaster caster = volume.caster(target);
    CrossingImage kept(kSize), behind(kSize);
    const std::vector<float> open(kept.points.size(), 0.0f);
    for (int k = 0; k < 12; ++k) {
      PictureRays rays = view(k, volume.grid.dims());
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
  const Prepared volume({test::phantomGrid("torus", 32), {0.0}});
  const SurfaceCaster caster = volume.caster(TracerTarget::automatic);
  for (int k = 0; k < 8; ++k) {
    const CrossingImage picture = cast(caster, view(k, volume.grid.dims()));
    PictureArea expected(kSize);
    for (int y = 0; y < kSize.y; ++y)
      for (int x = 0; x < kSize.x; ++x)
        if (picture.points[static_cast<std::size_t>(y * kSize.x + x)].w >= 0.0f) expected.add(y, x, x + 1);
    EXPECT_EQ(picture.area.rectangles(), expected.rectangles());
  }
}

}  // namespace
}  // namespace isolux::volume
