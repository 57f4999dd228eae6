// First hits in double precision (volume/hit): those of searches that share no arithmetic with them.
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/properties/agreeing_hits.h"
#include "tests/properties/property_run.h"
#include "tests/properties/searched_ray.h"
#include "tests/support/rays.h"
#include "tests/volume/cast/caster_checks.h"
#include "volume/field/reconstruct.h"
#include "volume/hit/exact_hit.h"

namespace isolux::test {
namespace {

using volume::Grid;
using volume::Ray;

// Rays of every kind, and those of the case's camera.
std::vector<Ray> raysOfCase(const PropertyCase& made, const Grid& grid, std::uint64_t count) {
  std::vector<Ray> rays;
  for (std::uint64_t i = 0; i < count; ++i) rays.push_back(randomRay(64 * made.seed + i, grid.dims()));
  const volume::PictureRays picture = raysOf(made.camera(grid.geometry()), grid.geometry(), made.picture);
  for (std::uint64_t i = 0; i < count; ++i) {
    const glm::dvec2 pixel(static_cast<int>(i * 7) % made.picture.x,
                           static_cast<int>(i * 5) % made.picture.y);
    rays.push_back(rayThrough(picture, pixel + 0.5));
  }
  return rays;
}

// In a plane of voxels between a cell with a missing corner and one without, either answer is right.
bool runsBetweenCells(const Ray& ray) {
  for (int axis = 0; axis < 3; ++axis)
    if (ray.direction[axis] == 0.0 && ray.origin[axis] == std::round(ray.origin[axis])) return true;
  const glm::dvec3 d = glm::abs(ray.direction);
  return d.x == d.y || d.y == d.z || d.x == d.z || ray.origin == glm::round(ray.origin);
}

std::string firstHitsAgree(const PropertyCase& made) {
  const Grid grid = made.grid();
  const double isovalue = made.isovalueIn(grid);
  base::Progress progress;
  const volume::MinMaxBlocks blocks(grid, made.seed % 2 == 0 ? 4 : 8, progress);
  const TrilinearOracle oracle(grid);
  const double scale = std::max({grid.maximum() - grid.minimum(), std::abs(isovalue)});
  for (const Ray& ray : raysOfCase(made, grid, 48)) {
    if (grid.missingCount() > 0 && runsBetweenCells(ray)) continue;
    const auto hit = volume::firstHit(grid, blocks, isovalue, ray);
    if (std::string wrong = disagreement(oracle, isovalue, ray, hit); !wrong.empty()) return wrong;
    if (!hit) continue;
    if (!(hit->valueError <= 1e-9 * scale)) return "a hit is off the surface: " + textOf(ray);
    if (!(std::abs(volume::sampleTrilinear(grid, hit->voxel).value - isovalue) <= 1e-9 * scale))
      return "a hit's value error is larger than stated: " + textOf(ray);
    if (!(glm::distance(hit->voxel, ray.origin + hit->t * ray.direction) <
          1e-9 * (1.0 + glm::length(ray.origin))))
      return "a hit is off its ray: " + textOf(ray);
  }
  return {};
}

TEST(HitProperties, FirstHitsAreThoseOfAnIndependentSearch) {
  expectHolds("FirstHits", 0.09, firstHitsAgree);
}

// Rounding of the field's own arithmetic, as a part of its range: some 60 operations of 2^-53 each.
constexpr double kDoubleRounding = 1e-13;

std::string cubicHitsAgree(const PropertyCase& made) {
  const Grid grid = made.grid();
  const double isovalue = made.isovalueIn(grid);
  for (const scene::Field kind : {scene::Field::cubic, scene::Field::cubic_interpolating}) {
    const casting::Prepared volume(made.grid(), {isovalue}, kind);
    const DoubleField field(grid, kind);
    const double stored = grid.storedOfValue(isovalue);
    const double size = std::max({field.range(), std::abs(stored), std::abs(field.least()),
                                  std::abs(grid.intercept() / grid.slope())});
    const double margin = 1e-6 * field.range() + 16.0 * kDoubleRounding * size;
    for (const Ray& ray : raysOfCase(made, grid, 6)) {
      if (grid.missingCount() > 0 && runsBetweenCells(ray)) continue;
      const volume::CubicHit found = volume.firstHit(isovalue, ray);
      const auto clear = firstClearCrossing(field, stored, margin, 1e-9, ray);
      // Before a place where it cannot tell the hit may be any.
      if (clear && !found.certain && found.tUncertain <= clear->t) continue;
      if (clear && !(found.hit && found.hit->t <= clear->t * (1.0 + 1e-12)))
        return "a crossing of the spline is missed: " + textOf(ray);
      if (!found.hit) continue;
      const double off = field(found.hit->voxel) - stored;
      if (!(std::abs(off) <= 1e-9 * field.rangeAt(found.hit->voxel) + kDoubleRounding * size))
        return "a hit is off the spline's surface by " + exactText(off / size) + ": " + textOf(ray);
    }
  }
  return {};
}

TEST(HitProperties, CubicHitsAreThoseOfADenseSearch) {
  expectHolds("CubicHits", 0.09, cubicHitsAgree);
}

}  // namespace
}  // namespace isolux::test
