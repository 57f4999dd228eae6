// What changes nothing: turning, mirroring and exchanging the axes of the grid, scaling the values and adding
// to them, with everything else going along. Exactly, where the arithmetic is.
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "base/random.h"
#include "scene/camera.h"
#include "tests/properties/agreeing_hits.h"
#include "tests/properties/exchanged_axes.h"
#include "tests/properties/property_run.h"
#include "tests/support/rays.h"
#include "tests/support/volumes.h"
#include "tests/volume/cast/caster_checks.h"
#include "volume/field/value_scaling.h"
#include "volume/hit/exact_hit.h"

namespace isolux::test {
namespace {

using volume::Grid;
using volume::Ray;

// Another volume in which each ray of the first has a hit at the same t.
struct SameHits {
  Grid grid;
  double isovalue;
  AxisExchange exchange{};
};

// Hits in the other volume are hits of this one, by the independent search.
std::string haveSameHits(const PropertyCase& made, const Grid& grid, double isovalue, const SameHits& other,
                         const char* what) {
  base::Progress progress;
  const volume::MinMaxBlocks blocks(other.grid, 4, progress);
  const TrilinearOracle oracle(grid);
  for (std::uint64_t i = 0; i < 32; ++i) {
    const Ray ray = randomRay(64 * made.seed + i, grid.dims());
    if (grid.missingCount() > 0 && i % 8 > 2) continue;  // between cells either is right
    const auto hit = volume::firstHit(
        other.grid, blocks, other.isovalue,
        {other.exchange.point(ray.origin, grid.dims()), other.exchange.direction(ray.direction)});
    if (const std::string wrong = disagreement(oracle, isovalue, ray, hit); !wrong.empty())
      return std::string(what) + ": " + wrong;
  }
  return {};
}

std::string axesMayBeExchanged(const PropertyCase& made) {
  const Grid grid = made.grid();
  const double isovalue = made.isovalueIn(grid);
  for (std::uint64_t k = 0; k < 3; ++k) {
    const AxisExchange exchange = exchangeOf(3 * made.seed + k);
    if (std::string wrong =
            haveSameHits(made, grid, isovalue, {exchanged(grid, exchange), isovalue, exchange}, "exchanged");
        !wrong.empty())
      return wrong;
  }
  return {};
}

TEST(InvarianceProperties, AxesMayBeExchangedAndMirrored) {
  expectHolds("AxesMayBeExchanged", 0.06, axesMayBeExchanged);
}

// Float voxels, each by a function of its value.
template <class Change>
Grid changedValues(const Grid& grid, const Change& change) {
  return casting::changed(grid, [&](glm::ivec3, double value) { return static_cast<float>(change(value)); });
}

// A power of two by which no value leaves the range of normal floats, nor did before; 0: there is none.
int roomOf(const Grid& grid) {
  const double most = std::max(std::abs(grid.minimum()), std::abs(grid.maximum()));
  double least = most;
  for (const float v : std::get<std::vector<float>>(grid.voxels()))
    if (v != 0.0f && std::fabs(v) < least) least = static_cast<double>(std::fabs(v));
  return most < 0x1p30 && least > 0x1p-60 ? 40 : 0;
}

// A difference of texels, in values.
double valueOf(const Grid& grid, float texels) {
  return std::ldexp(static_cast<double>(texels),
                    volume::scalingOf(grid.storedMinimum(), grid.storedMaximum()).exponent);
}

std::string valuesMayBeScaled(const PropertyCase& drawn) {
  PropertyCase made = drawn;
  made.type = "float32", made.slope = 1.0, made.intercept = 0.0;
  const Grid grid = made.grid();
  const double isovalue = made.isovalueIn(grid);
  const int room = roomOf(grid);
  if (room == 0 || !(isovalue == 0.0 || std::abs(isovalue) > 0x1p-60)) return {};
  const double factor = std::ldexp(1.0, static_cast<int>(made.seed % 81) - room);
  const Grid scaled = changedValues(grid, [&](double v) { return factor * v; });
  base::Progress progress;
  const volume::MinMaxBlocks blocks(grid, 8, progress), scaledBlocks(scaled, 8, progress);
  for (std::uint64_t i = 0; i < 32; ++i) {
    const Ray ray = randomRay(64 * made.seed + i, grid.dims());
    const auto hit = volume::firstHit(grid, blocks, isovalue, ray);
    const auto other = volume::firstHit(scaled, scaledBlocks, factor * isovalue, ray);
    if (hit.has_value() != other.has_value() || (hit && hit->t != other->t))
      return "scaled by a power of two: ray " + std::to_string(i);
  }
  const volume::PictureRays rays = raysOf(made.camera(grid.geometry()), grid.geometry(), made.picture);
  for (const volume::TracerTarget target : casting::targets()) {
    const casting::Prepared one(made.grid(), {isovalue}),
        two(changedValues(grid, [&](double v) { return factor * v; }), {factor * isovalue});
    volume::CrossingImage picture(made.picture), same(made.picture);
    one.caster(target).castAll(rays, picture);
    two.caster(target).castAll(rays, same);
    bool differs = picture.points != same.points;
    for (std::size_t i = 0; i < picture.infos.size() && !differs; ++i) {
      const glm::vec2 info = picture.infos[i], other = same.infos[i];
      differs = factor * valueOf(grid, info.x) != valueOf(scaled, other.x) || info.y != other.y;
    }
    if (differs) return "scaled by a power of two: the pictures differ";
  }
  return {};
}

TEST(InvarianceProperties, ValuesMayBeScaledByPowersOfTwo) {
  expectHolds("ValuesMayBeScaled", 0.06, valuesMayBeScaled);
}

// Integers: sums with others are exact.
std::string valuesMayBeShiftedAndTurned(const PropertyCase& drawn) {
  PropertyCase made = drawn;
  made.type = "int8", made.slope = 1.0, made.intercept = 0.0;
  const Grid grid = made.grid();
  const double isovalue = std::round(2.0 * made.isovalueIn(grid)) / 2.0;
  const double shift = static_cast<double>(made.seed % 20001) - 10000.0;
  const auto& voxels = std::get<std::vector<std::int8_t>>(grid.voxels());
  const auto shifted = changedValues(grid, [&](double v) { return v + shift; });
  std::vector<std::int16_t> turned;
  for (const std::int8_t v : voxels) turned.push_back(static_cast<std::int16_t>(-v));
  for (const auto& [other, what] :
       {std::pair{SameHits{shifted, isovalue + shift}, "shifted"},
        std::pair{SameHits{Grid(grid.geometry(), voxels, 1.0, shift), isovalue + shift}, "with an intercept"},
        std::pair{SameHits{Grid(grid.geometry(), turned, -1.0, 0.0), isovalue}, "with a falling slope"},
        std::pair{SameHits{Grid(grid.geometry(), turned, 1.0, 0.0), -isovalue}, "turned over"}})
    if (std::string wrong = haveSameHits(made, grid, isovalue, other, what); !wrong.empty()) return wrong;
  return {};
}

TEST(InvarianceProperties, ConstantsMayBeAddedAndSignsTurned) {
  expectHolds("ValuesMayBeShifted", 0.06, valuesMayBeShiftedAndTurned);
}

// Grid and camera turned together: the rays in voxel space stay.
std::string worldMayBeTurned(const PropertyCase& made) {
  const volume::GridGeometry geometry = made.grid().geometry();
  const auto number = [&](std::uint64_t i) { return 2.0 * base::uniformNoise(made.seed, i) - 1.0; };
  const glm::dmat3 turn =
      glm::mat3_cast(glm::normalize(glm::dquat(number(0), number(1), number(2), number(3))));
  const scene::Camera camera = made.camera(geometry);
  if (*camera.eye == *camera.target) return {};
  // Where up is along the view another one is taken, which is the world's.
  const glm::dvec3 view = glm::normalize(*camera.target - *camera.eye);
  if (glm::length(glm::cross(view, *camera.up)) < 1e-3) return {};
  volume::GridGeometry turned = geometry;
  turned.worldFromVoxel = glm::dmat4(turn) * geometry.worldFromVoxel;
  scene::Camera turnedCamera = camera;
  turnedCamera.eye = turn * *camera.eye;
  turnedCamera.target = turn * *camera.target;
  turnedCamera.up = turn * *camera.up;
  const volume::PictureRays rays = raysOf(camera, geometry, made.picture),
                            other = raysOf(turnedCamera, turned, made.picture);
  const double size = glm::length(glm::dvec3(made.dims));
  for (const glm::dvec2& fragment : {glm::dvec2(0.0), glm::dvec2(made.picture), glm::dvec2(3.5, 1.5)}) {
    const Ray a = rayThrough(rays, fragment), b = rayThrough(other, fragment);
    const double apart = glm::distance(a.origin, b.origin) +
                         size * glm::distance(a.direction, b.direction) / glm::length(a.direction);
    const double limit = 2.0 * roundingOf(rays, made.dims, size / glm::length(a.direction));
    if (!(apart <= limit))
      return "rays turn by " + exactText(apart) + " voxels where " + exactText(limit) + " is the bound";
  }
  return {};
}

TEST(InvarianceProperties, TheWorldMayBeTurned) {
  expectHolds("WorldMayBeTurned", 0.02, worldMayBeTurned);
}

}  // namespace
}  // namespace isolux::test
