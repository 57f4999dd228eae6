// A little more isovalue moves hits a little, and in the right direction; so does a little of the camera.
// Said of pixels where the field along the ray is steep in the cell of the hit; of those that graze, nothing.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "base/random.h"
#include "tests/properties/property_run.h"
#include "tests/support/rays.h"
#include "volume/field/reconstruct.h"
#include "volume/hit/exact_hit.h"

namespace isolux::test {
namespace {

using volume::Grid;
using volume::Ray;
using volume::RayHit;

// A hit's cell along the ray: how steep the field is there, and how much that can change per t.
struct Steepness {
  double slope, change;
  double tBegin, tEnd;  // of the ray in the cell
};

std::optional<Steepness> steepnessAt(const Grid& grid, const Ray& ray, const RayHit& hit) {
  Steepness at{glm::dot(volume::sampleTrilinear(grid, hit.voxel).gradient, ray.direction), 0.0, -HUGE_VAL,
               HUGE_VAL};
  glm::ivec3 cell;
  for (int axis = 0; axis < 3; ++axis) {
    cell[axis] = std::clamp(static_cast<int>(std::floor(hit.voxel[axis])), 0, grid.dims()[axis] - 2);
    const double d = ray.direction[axis], low = cell[axis] - ray.origin[axis], high = low + 1.0;
    if (d == 0.0) continue;
    at.tBegin = std::max(at.tBegin, std::min(low / d, high / d));
    at.tEnd = std::min(at.tEnd, std::max(low / d, high / d));
  }
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (int i = 0; i < 8; ++i) {
    const double value = grid.value(cell.x + (i & 1), cell.y + (i >> 1 & 1), cell.z + (i >> 2));
    if (!(value >= least)) least = value;
    if (!(value <= most)) most = value;
  }
  // f'' = 2 (dx dy f_xy + dy dz f_yz + dz dx f_zx), each mixed derivative at most twice the range.
  const glm::dvec3 d = glm::abs(ray.direction);
  at.change = 4.0 * (most - least) * (d.x * d.y + d.y * d.z + d.z * d.x);
  if (!(hit.t > at.tBegin && hit.t < at.tEnd)) return std::nullopt;
  return at;
}

// What t a hit moves by at most where f changes by `by`: within the cell, and with at least `least` of the
// slope.
struct Move {
  double t, least;
};
std::optional<Move> moveOf(const Steepness& at, double tHit, double by) {
  const double slope = std::abs(at.slope);
  if (!(slope > 0.0)) return std::nullopt;
  const double window = 2.0 * by / slope, least = slope - at.change * window;
  if (!(least >= 0.5 * slope) || tHit + window >= at.tEnd || tHit - window <= at.tBegin) return std::nullopt;
  return Move{by / least, least};
}

std::string hitsMoveWithTheIsovalue(const PropertyCase& made) {
  const Grid grid = made.grid();
  if (grid.missingCount() > 0) return {};  // sides behind gaps are found anew
  const double isovalue = made.isovalueIn(grid), range = grid.maximum() - grid.minimum();
  if (!(range > 0.0)) return {};
  base::Progress progress;
  const volume::MinMaxBlocks blocks(grid, 8, progress);
  // Rounding of values and places in double precision.
  const double rounding = 1e-13 * std::max({std::abs(grid.minimum()), std::abs(grid.maximum()), range});
  for (std::uint64_t i = 0; i < 64; ++i) {
    const Ray ray = randomRay(64 * made.seed + i, grid.dims());
    const double more = range * std::pow(10.0, -3.0 - static_cast<double>(i % 5));
    if (more < 1e3 * rounding) continue;
    const auto hit = volume::firstHit(grid, blocks, isovalue, ray);
    if (!hit) continue;
    const auto at = steepnessAt(grid, ray, *hit);
    const auto move = at ? moveOf(*at, hit->t, more + rounding) : std::nullopt;
    if (!move) continue;
    // Farther away from where the ray comes from, in values: a ray that enters at the isovalue enters more
    // than that later, and not much.
    const double farther = hit->entering ? isovalue + more : isovalue - more;
    const auto later = volume::firstHit(grid, blocks, farther, ray);
    const double slack = rounding / move->least + 1e-12 * (1.0 + std::abs(hit->t));
    const auto says = [&](const char* what) {
      return std::string(what) + ", ray " + std::to_string(i) + ", isovalue and " + exactText(more);
    };
    if (!later) return says("a hit vanishes");
    if (later->t < hit->t - slack) return says("a hit comes nearer");
    if (later->t > hit->t + move->t + slack) return says("a hit jumps");
  }
  return {};
}

TEST(ContinuityProperties, HitsMoveWithTheIsovalue) {
  expectHolds("HitsMoveWithTheIsovalue", 0.05, hitsMoveWithTheIsovalue);
}

// The camera moves by `by` voxels at most, and the ray keeps its direction.
std::string hitsMoveWithTheCamera(const PropertyCase& made) {
  const Grid grid = made.grid();
  if (grid.missingCount() > 0) return {};
  const double isovalue = made.isovalueIn(grid), range = grid.maximum() - grid.minimum();
  base::Progress progress;
  const volume::MinMaxBlocks blocks(grid, 8, progress);
  const double rounding = 1e-13 * std::max({std::abs(grid.minimum()), std::abs(grid.maximum()), range});
  for (std::uint64_t i = 0; i < 64; ++i) {
    const Ray ray = randomRay(64 * made.seed + i, grid.dims());
    const auto hit = volume::firstHit(grid, blocks, isovalue, ray);
    if (!hit) continue;
    const double by = std::pow(10.0, -4.0 - static_cast<double>(i % 4));
    Ray moved = ray;
    moved.origin += by * glm::normalize(randomVector(i, 77) - 0.5);
    // The shifted ray stays in the cell by as much, and f differs by at most the range per voxel and axis.
    const auto at = steepnessAt(grid, ray, *hit);
    const auto move = at ? moveOf(*at, hit->t, std::sqrt(3.0) * by * range + rounding) : std::nullopt;
    if (!move) continue;
    const glm::dvec3 inCell = hit->voxel - glm::floor(hit->voxel);
    const double reach = 2.0 * (by + move->t * glm::length(ray.direction));
    if (glm::any(glm::lessThan(inCell, glm::dvec3(reach))) ||
        glm::any(glm::greaterThan(inCell, glm::dvec3(1.0 - reach))))
      continue;
    const auto other = volume::firstHit(grid, blocks, isovalue, moved);
    const double slack = rounding / move->least + 1e-12 * (1.0 + std::abs(hit->t));
    const auto says = [&](const char* what) { return std::string(what) + ", ray " + std::to_string(i); };
    // The ray goes through the surface here: not later. The same surface, or another that the ray of before
    // came as near to as it was moved.
    if (!other || other->t > hit->t + move->t + slack) return says("a hit jumps away");
    if (other->t >= hit->t - move->t - slack) continue;
    const double near = volume::sampleTrilinear(grid, ray.origin + other->t * ray.direction).value - isovalue;
    const bool beside = glm::any(glm::lessThan(other->voxel, glm::dvec3(by))) ||
                        glm::any(glm::greaterThan(other->voxel, glm::dvec3(grid.dims()) - 1.0 - by));
    if (!beside && !(std::abs(near) <= std::sqrt(3.0) * by * range + rounding))
      return says("a hit jumps nearer");
  }
  return {};
}

TEST(ContinuityProperties, HitsMoveWithTheCamera) {
  expectHolds("HitsMoveWithTheCamera", 0.05, hitsMoveWithTheCamera);
}

}  // namespace
}  // namespace isolux::test
