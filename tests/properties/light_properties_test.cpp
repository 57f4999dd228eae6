// Light of path tracing (gi/trace): never negative, and of every single path at most what sky or lamps can
// give.
//
// A path that only follows the cosine carries pi times the product of its albedos, over the chance to survive
// where that is drawn; it ends where it escapes. So no path is worth more than pi L_max. One that is a shadow
// ray to the sky for a share of its directions is worth more by 1 / (1 - share) at each of its vertices at
// most. A distant lamp of irradiance E adds at most E at each vertex, times the albedos before: E / (1 -
// albedo) in all.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/random.h"
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
    const auto hit = volume::firstHit(grid, blocks, isovalue, ray.origin, ray.direction);
    if (!hit) continue;
    gi::LightPoint point;
    point.voxel = glm::vec3(hit->voxel);
    point.isovalue = static_cast<float>(grid.storedOfValue(isovalue));
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
  }

  lit.light.environment = nullptr;
  lit.light.environmentShare = 0.0;
  const double irradiance = 3.0;
  lit.light.lamps = {{.kind = scene::LampKind::directional, .toward = sun, .power = glm::dvec3(irradiance)}};
  // Paths that survive by chance are worth what they were.
  double limit = irradiance, throughput = 1.0;
  for (int bounce = 1; bounce <= lit.light.bounces; ++bounce) {
    if (bounce < std::max(0, lit.light.rouletteDepth)) throughput *= albedo;
    limit += irradiance * throughput;
  }
  return pathsLieWithin(lit, gi::LightPart::lamps, limit, "a distant lamp");
}

TEST(LightProperties, LightIsWithinWhatThereIs) {
  expectHolds("LightIsWithinWhatThereIs", 0.07, lightIsWithinWhatThereIs);
}

}  // namespace
}  // namespace isolux::test
