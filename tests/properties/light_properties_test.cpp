// Light of path tracing (gi/trace): never negative, and of every single path at most what sky or lamps can
// give.
//
// A path that only follows the cosine carries pi times the product of its albedos, over the chance to survive
// where that is drawn; it ends where it escapes. So no path is worth more than pi L_max. One that is a shadow
// ray to the sky for a share of its directions is worth more by 1 / (1 - share) at each of its vertices at
// most. A lamp of which no point has more than the irradiance E adds at most E at each vertex, times the
// albedos before: E / (1 - albedo) in all. Stored texels are means of such paths.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/random.h"
#include "gi/trace/lattice_estimator.h"
#include "gi/trace/path_tracer.h"
#include "tests/gi/light_fixture.h"
#include "tests/properties/property_run.h"
#include "tests/support/rays.h"
#include "tests/support/volumes.h"
#include "volume/hit/exact_hit.h"

namespace isolux::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::uint32_t kPaths = 16;

// Of floats, some ten operations a bounce.
double roundingOf(int bounces) {
  return 1.0 + 1e-6 * (10 + bounces);
}

struct LitCase {
  gi::LightScene light;
  std::vector<gi::LightPoint> points;
};

// Points of the surface as rays see them, with the normals of the light's own field.
LitCase litCase(const PropertyCase& made, double albedo, scene::Inside inside) {
  const auto volume = prepared(made.grid());
  const volume::Grid& grid = volume->grid();
  LitCase lit{lightSceneOf(volume, inside, glm::dvec3(albedo)), {}};
  const gi::PathTracer tracer = tracerOf(lit.light);
  const double isovalue = made.isovalueIn(grid);
  base::Progress progress;
  const volume::MinMaxBlocks blocks(grid, 8, progress);
  for (std::uint64_t i = 0; i < 12; ++i) {
    const volume::Ray ray = randomRay(64 * made.seed + 8 * i, grid.dims());
    const auto hit = volume::firstHit(grid, blocks, isovalue, ray);
    if (!hit) continue;
    gi::LightPoint point;
    point.voxel = glm::vec3(hit->voxel);
    point.isovalue = grid.storedIsovalue(isovalue);
    glm::vec3 gradient;
    tracer.light().tracer->gradients(std::span(&point.voxel, 1), std::span(&gradient, 1));
    point.normal = tracer.normalOf(gradient);
    point.seed = static_cast<std::uint32_t>(i);
    if (point.normal != glm::vec3(0.0f)) lit.points.push_back(point);
  }
  return lit;
}

// Each path's estimate of each point lies in [0, limit].
std::string pathsLieWithin(const LitCase& lit, gi::LightPart part, double limit, const char* what) {
  const gi::PathTracer tracer = tracerOf(lit.light);
  std::vector<glm::vec3> means(lit.points.size());
  std::uint64_t rays = 0;
  for (std::uint32_t path = 0; path < kPaths && !lit.points.empty(); ++path) {
    if (!tracer.irradiance(part, lit.points, {path, 1}, means, {}, rays, {})) return "stopped";
    for (std::size_t i = 0; i < means.size(); ++i)
      for (int channel = 0; channel < 3; ++channel) {
        const double e = static_cast<double>(means[i][channel]);
        if (!(e >= 0.0 && e <= limit * roundingOf(lit.light.bounces)))
          return std::string(what) + ": point " + std::to_string(i) + ", path " + std::to_string(path) +
                 " has " + exactText(e) + " where " + exactText(limit) + " is the bound";
      }
  }
  return {};
}

// So does each texel of a lattice: those that have a normal, of the isovalue that is shown or each of its
// own.
std::string texelsLieWithin(const PropertyCase& made, const LitCase& lit, gi::LightPart part, double limit,
                            const char* what) {
  if (lit.points.empty()) return {};
  const double scales[] = {0.5, 1.0, 2.0};
  const std::optional<float> isovalue =
      made.seed % 2 == 0 ? std::optional(lit.points.front().isovalue) : std::nullopt;
  const gi::LatticeGeometry lattice = gi::LatticeGeometry::make(made.dims, scales[made.seed % 3], isovalue);
  const gi::LatticeEstimator estimator(std::make_shared<const gi::LightScene>(lit.light), lattice, part);
  std::vector<glm::ivec3> texels;
  for (std::uint64_t i = 0; i < 24; ++i)
    texels.emplace_back(randomVector(made.seed, 16 + i) * glm::dvec3(lattice.dims));
  std::vector<gi::TexelPoint> points(texels.size());
  estimator.points(texels, points);
  const auto components = static_cast<std::size_t>(estimator.content().components());
  std::vector<double> sums(texels.size() * components);
  std::uint64_t rays = 0;
  if (!estimator.add(texels, points, {0, kPaths}, sums, rays, {})) return "stopped";
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const double mean = sums[i] / kPaths;
    if (points[i / components].normal != glm::vec3(0.0f) &&
        !(mean >= 0.0 && mean <= limit * roundingOf(lit.light.bounces)))
      return std::string(what) + ": texel " + std::to_string(i / components) + " has " + exactText(mean) +
             " where " + exactText(limit) + " is the bound";
  }
  return {};
}

// A lamp, and the most irradiance that it can give to any point of the volume.
struct BoundedLamp {
  const char* name;
  gi::LampLight light;
  double most;
};

// Lamps near by are outside of the volume, `away` mm or more from all of it.
std::vector<BoundedLamp> boundedLamps(const LitCase& lit, const glm::dvec3& toward, double away) {
  using enum scene::LampKind;
  const scene::VolumeFacts& facts = lit.light.volume->facts;
  const glm::dvec3 middle = 0.5 * (facts.boundsMinMm + facts.boundsMaxMm);
  const glm::dvec3 place =
      middle + toward * (0.5 * glm::distance(facts.boundsMinMm, facts.boundsMaxMm) + away);
  const double cosHalfAngle = 0.8, radius = 0.6 * away;
  const double cosOfBall = std::sqrt(1.0 - radius * radius / (away * away));
  return {{"a distant lamp", {.kind = directional, .toward = toward, .power = glm::dvec3(3.0)}, 3.0},
          {"a disc in the sky",
           {.kind = directional, .toward = toward, .cosHalfAngle = cosHalfAngle, .power = glm::dvec3(3.0)},
           3.0 * 2.0 * kPi * (1.0 - cosHalfAngle)},
          {"a point", {.kind = point, .positionMm = place, .power = glm::dvec3(3.0)}, 3.0 / (away * away)},
          {"a luminous sphere",
           {.kind = sphere, .positionMm = place, .radiusMm = radius, .power = glm::dvec3(3.0)},
           3.0 * 2.0 * kPi * (1.0 - cosOfBall)}};
}

std::string lightIsWithinWhatThereIs(const PropertyCase& made) {
  const auto number = [&](std::uint64_t i) { return base::uniformNoise(made.seed, i); };
  const double albedo = made.seed % 4 == 0 ? 1.0 : 0.95 * number(0);
  const auto inside = made.seed % 2 == 0 ? scene::Inside::above : scene::Inside::below;
  LitCase lit = litCase(made, albedo, inside);
  lit.light.bounces = static_cast<int>(made.seed % 7);
  lit.light.rouletteDepth = static_cast<int>(made.seed % 5);
  lit.light.sequence = made.seed % 3 == 0 ? scene::DirectionSequence::r2 : scene::DirectionSequence::random;

  setUnitSky(lit.light);
  if (std::string wrong = pathsLieWithin(lit, gi::LightPart::sky, kPi, "unit sky"); !wrong.empty())
    return wrong;

  lit.light.choice.unitSky = false;
  double brightest = 0.0;
  const glm::dvec3 sun = glm::normalize(randomVector(made.seed, 5) - 0.5);
  lit.light.environment = environmentOf(16, 8, [&](const glm::dvec3& direction) {
    const double radiance = 0.2 + 50.0 * std::pow(std::max(0.0, glm::dot(direction, sun)), 20.0);
    brightest = std::max(brightest, radiance);
    return radiance;
  });
  for (const double share : {0.0, 0.5}) {
    lit.light.environmentShare = share;
    const double limit = kPi * brightest * std::pow(1.0 - share, -(lit.light.bounces + 1));
    if (std::string wrong = pathsLieWithin(lit, gi::LightPart::sky, limit, "environment"); !wrong.empty())
      return wrong;
    if (std::string wrong = texelsLieWithin(made, lit, gi::LightPart::sky, limit, "environment");
        !wrong.empty())
      return wrong;
  }

  lit.light.environment = nullptr;
  lit.light.environmentShare = 0.0;
  const double away = std::exp(6.0 * number(1) - 3.0) * glm::length(made.spacing);
  for (const BoundedLamp& lamp : boundedLamps(lit, sun, away)) {
    lit.light.lamps = {lamp.light};
    // Paths that survive by chance are worth what they were. Where a point lies, floats round.
    const double most = lamp.most * (1.0 + 1e-4);
    double limit = most, throughput = 1.0;
    for (int bounce = 1; bounce <= lit.light.bounces; ++bounce) {
      if (bounce < std::max(0, lit.light.rouletteDepth)) throughput *= albedo;
      limit += most * throughput;
    }
    if (std::string wrong = pathsLieWithin(lit, gi::LightPart::lamps, limit, lamp.name); !wrong.empty())
      return wrong;
    if (std::string wrong = texelsLieWithin(made, lit, gi::LightPart::lamps, limit, lamp.name);
        !wrong.empty())
      return wrong;
  }
  return {};
}

TEST(LightProperties, LightIsWithinWhatThereIs) {
  expectHolds("LightIsWithinWhatThereIs", 0.07, lightIsWithinWhatThereIs);
}

}  // namespace
}  // namespace isolux::test
