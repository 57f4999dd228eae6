// Light after bounces: furnaces, Russian roulette, transfer, and what must never change a result.
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "gi/harmonics/spherical_harmonics.h"
#include "gi/sampling/directions.h"
#include "tests/gi/light_fixture.h"
#include "tests/support/spherical_functions.h"
#include "tests/support/statistics.h"
#include "tests/support/volumes.h"

namespace isolux::gi {
namespace {

using namespace isolux::test;
using volume::GridGeometry;

using std::numbers::pi;

constexpr double cavityRadius = 20.0, lampRadius = 2.0, lampRadiance = 5.0;

// A closed spherical cavity with a luminous sphere in its middle. Every point of the wall gets E0 = pi L,
// L = radiance (r / R)^2, from it; the wall's light on itself is even (a sphere's form factor between any two
// parts depends on their areas only), so each bounce adds albedo times what came before:
//   E = pi L (1 + albedo + ... + albedo^bounces), in the limit pi L / (1 - albedo).
// Lamps are no obstacle. The wall of interpolated voxels lies up to 0.01 mm from the sphere: L is 0.1 % off
// at most, far below the standard errors here; the point's own distance is exact.
LightScene cavity(glm::dvec3 albedo, int bounces) {
  LightScene light =
      lightSceneOf(volumeOf(cube(48), [](glm::dvec3 p) { return cavityRadius - glm::length(p); }),
                   scene::Inside::below, albedo);
  LampLight lamp;
  lamp.kind = scene::LampKind::sphere;
  lamp.radiusMm = lampRadius;
  lamp.power = glm::dvec3(lampRadiance);
  light.lamps = {lamp};
  light.bounces = bounces;
  return light;
}
const glm::dvec3 wallDirection = glm::normalize(glm::dvec3(0.36, -0.48, 0.8));
const double cavityDirect = pi * lampRadiance * (lampRadius * lampRadius) / (cavityRadius * cavityRadius);

TEST(PathTracerBounces, AFurnaceGivesTheGeometricSeries) {
  for (const double albedo : {0.2, 0.7}) {
    for (const int bounces : {0, 1, 4}) {
      const PathTracer tracer = tracerOf(cavity(glm::dvec3(albedo), bounces));
      const Estimate e =
          estimate(tracer, LightPart::lamps, pointAt(tracer, cavityRadius * wallDirection), 20000);
      const double series = (1.0 - std::pow(albedo, bounces + 1)) / (1.0 - albedo);
      EXPECT_TRUE(agrees(e, cavityDirect * series)) << albedo << ' ' << bounces;
    }
  }
}

TEST(PathTracerBounces, AFurnaceReachesItsLimitByRussianRouletteChannelByChannel) {
  const glm::dvec3 albedo(0.8, 0.5, 0.1);
  LightScene light = cavity(albedo, 200);
  light.rouletteDepth = 2;
  const PathTracer tracer = tracerOf(std::move(light));
  const LightPoint point = pointAt(tracer, cavityRadius * wallDirection);
  constexpr std::uint32_t parts = 50, samplesOfPart = 800;
  Moments channels[3];
  std::uint64_t rays = 0;
  for (std::uint32_t part = 0; part < parts; ++part) {
    const Estimate e = estimate(tracer, LightPart::lamps, point, samplesOfPart, part * samplesOfPart);
    for (int channel = 0; channel < 3; ++channel) channels[channel].add(e.mean[channel]);
    rays += e.rays;
  }
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_LT(std::abs(channels[channel].z(cavityDirect / (1.0 - albedo[channel]))), 4.5) << channel;
  // Two rays a bounce; on average 1 + 0.8 / (1 - 0.8) bounces are begun, not 200.
  EXPECT_LT(rays, parts * samplesOfPart * 13u);
  EXPECT_EQ(tracer.cappedPaths(), 0u);
}

// Under a sky of radiance 1 and with albedo 1 every path comes out with all it had: E = pi on any surface,
// whatever its normals and however often paths bounce. Nothing may get lost on the way.
TEST(PathTracerBounces, AlbedoOneUnderAnEvenSkyLosesNothing) {
  for (const char* name : {"gyroid", "two_balls", "head", "noise"}) {
    LightScene light = lightSceneOf(test::phantom(name, 40), scene::Inside::above, glm::dvec3(1.0));
    setUnitSky(light);
    light.bounces = 1000;
    const PathTracer tracer = tracerOf(std::move(light));
    const GridGeometry& geometry = tracer.light().volume->grid().geometry();
    for (int i = 0; i < 30; ++i) {
      const glm::dvec3 voxel(5 + 7 * i % 29, 3 + 11 * i % 31, 4 + 13 * i % 27);
      const LightPoint point = pointAt(tracer, glm::dvec3(geometry.worldFromVoxel * glm::dvec4(voxel, 1.0)));
      if (point.normal == glm::vec3(0.0f)) continue;
      const std::uint64_t before = tracer.cappedPaths();
      const Estimate e = estimate(tracer, LightPart::sky, point, 64);
      const double capped = static_cast<double>(tracer.cappedPaths() - before) / 64.0;
      EXPECT_NEAR(e.luminance, pi * (1.0 - capped), 1e-4) << name << ' ' << i;
    }
  }
}

TEST(PathTracerBounces, AlbedoOneInAClosedCavityStopsAndSaysSo) {
  LightScene light = cavity(glm::dvec3(1.0), 1000);
  setUnitSky(light);
  const PathTracer tracer = tracerOf(std::move(light));
  const LightPoint point = pointAt(tracer, cavityRadius * wallDirection);
  const Estimate sky = estimate(tracer, LightPart::sky, point, 16);
  EXPECT_EQ(sky.luminance, 0.0);
  EXPECT_EQ(sky.rays, 16u * 1001u);
  EXPECT_EQ(tracer.cappedPaths(), 16u);
  EXPECT_TRUE(agrees(estimate(tracer, LightPart::lamps, point, 16), cavityDirect * 1001.0));
  EXPECT_EQ(tracer.cappedPaths(), 32u);
}

TEST(PathTracerBounces, RussianRouletteChangesNoExpectation) {
  LightScene light = lightSceneOf(test::phantom("gyroid", 48), scene::Inside::above, {0.7, 0.4, 0.2});
  light.environment = environmentOf(16, 8, [](glm::dvec3 d) { return d.z > 0.0 ? 2.0 + d.x : 0.3; });
  light.bounces = 8;
  Estimate estimates[2];
  for (const int depth : {0, 1000}) {
    light.rouletteDepth = depth;
    const PathTracer tracer = tracerOf(light);
    estimates[depth > 0] =
        estimate(tracer, LightPart::sky, pointAt(tracer, {3.2, -2.6, 5.1}, 3u + (depth > 0)), 40000);
  }
  EXPECT_TRUE(agree(estimates[0], estimates[1]));
  EXPECT_LT(estimates[0].rays, estimates[1].rays * 3 / 4);
}

TEST(PathTracerBounces, BlackSurfacesReflectNothing) {
  LightScene light = lightSceneOf(test::phantom("gyroid", 32), scene::Inside::above, glm::dvec3(0.0));
  setUnitSky(light);
  const auto at = [&](int bounces) {
    light.bounces = bounces;
    const PathTracer tracer = tracerOf(light);
    return estimate(tracer, LightPart::sky, pointAt(tracer, {3.2, -2.6, 5.1}), 500);
  };
  const Estimate none = at(0), many = at(1000);
  EXPECT_EQ(none.mean, many.mean);
  EXPECT_EQ(none.rays, many.rays);
}

// An environment of the first bands alone: irradiance is the sum of transfer times coefficients (Wyman et al.
// 2006 eq. 9). The transfer's own variance comes from parts of its samples.
TEST(PathTracerBounces, TransferTimesEnvironmentIsIrradiance) {
  for (const int order : {1, 3, 5}) {
    std::vector<double> wanted(static_cast<std::size_t>(shTerms(order)));
    for (std::size_t i = 0; i < wanted.size(); ++i)
      wanted[i] = i == 0 ? 6.0 : std::sin(3.0 * static_cast<double>(i));
    const auto sky = environmentOf(
        256, 128, [&](glm::dvec3 d) { return 0.3 * test::reconstructSh(order, wanted, d) + 1.0; });
    const std::vector<glm::dvec3> bands = sky->project(order);
    LightScene light = lightSceneOf(test::phantom("gyroid", 48), scene::Inside::above, glm::dvec3(0.6));
    light.environment = sky;
    light.bounces = 2;
    light.shOrder = order;
    light.choice.channels = 3;
    const PathTracer tracer = tracerOf(light);
    const LightPoint point = pointAt(tracer, {3.2, -2.6, 5.1}, 9);
    constexpr int parts = 64, samplesOfPart = 500;
    double sum = 0.0, squares = 0.0;
    for (int part = 0; part < parts; ++part) {
      std::vector<double> transfer(3 * wanted.size(), 0.0);
      std::uint64_t rays = 0;
      ASSERT_TRUE(tracer.addTransfer(std::span(&point, 1),
                                     {static_cast<std::uint32_t>(part * samplesOfPart), samplesOfPart},
                                     transfer, rays, {}));
      double light1 = 0.0;
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        EXPECT_EQ(transfer[i], transfer[i + wanted.size()]);  // grey
        light1 += transfer[i] / samplesOfPart * bands[i].x;
      }
      sum += light1;
      squares += light1 * light1;
    }
    Estimate byTransfer;
    byTransfer.luminance = sum / parts;
    byTransfer.standardError = std::sqrt((squares - sum * sum / parts) / (parts - 1) / parts);
    LightPoint other = point;
    other.seed = 10;
    EXPECT_TRUE(agree(estimate(tracer, LightPart::sky, other, 32000), byTransfer)) << order;
  }
}

TEST(PathTracerBounces, TheColourOfTheSurfaceIsInTheTransfer) {
  LightScene light = lightSceneOf(test::phantom("gyroid", 32), scene::Inside::above, {0.9, 0.5, 0.0});
  light.bounces = 1;
  light.shOrder = 1;
  const PathTracer tracer = tracerOf(light);
  const LightPoint point = pointAt(tracer, {3.2, -2.6, 5.1});
  double transfer[3] = {};
  std::uint64_t rays = 0;
  ASSERT_TRUE(tracer.addTransfer(std::span(&point, 1), {0, 4000}, transfer, rays, {}));
  // What comes by one bounce is in proportion to the albedo.
  EXPECT_GT(transfer[0], transfer[1]);
  EXPECT_NEAR((transfer[0] - transfer[2]) / (transfer[1] - transfer[2]), 0.9 / 0.5, 1e-4);
}

// f and isovalue of the other sign, inside below: the same surface.
TEST(PathTracerBounces, InsideBelowIsTheSameOfTheNegative) {
  const Field gyroid = [](glm::dvec3 p) {
    return std::sin(0.4 * p.x) * std::cos(0.4 * p.y) + std::sin(0.4 * p.y) * std::cos(0.4 * p.z) +
           std::sin(0.4 * p.z) * std::cos(0.4 * p.x);
  };
  const auto lightAt = [](const Field& field, scene::Inside inside) {
    LightScene light = lightSceneOf(volumeOf(cube(32), field), inside);
    light.environment = environmentOf(16, 8, [](glm::dvec3 d) { return 1.0 + d.z; });
    light.bounces = 2;
    const PathTracer tracer = tracerOf(light);
    return estimate(tracer, LightPart::sky, pointAt(tracer, {3.0, 2.0, 1.0}), 4000);
  };
  const Estimate above = lightAt(gyroid, scene::Inside::above);
  const Estimate below = lightAt([&](glm::dvec3 p) { return -gyroid(p); }, scene::Inside::below);
  EXPECT_NEAR(above.luminance, below.luminance, 1e-4);
  EXPECT_EQ(above.rays, below.rays);
}

// Means do not depend on what else is asked for in the call, on the thread's past, or on how often.
TEST(PathTracerBounces, AResultIsThePointsAndTheRangesAlone) {
  LightScene light = lightSceneOf(test::phantom("gyroid", 40), scene::Inside::above, {0.7, 0.6, 0.5});
  light.environment = environmentOf(16, 8, [](glm::dvec3 d) { return d.z > 0.5 ? 9.0 : 0.5; });
  light.environmentShare = 0.4;
  light.bounces = 4;
  light.rouletteDepth = 2;
  light.sequence = scene::DirectionSequence::r2;
  LampLight lamp;
  lamp.kind = scene::LampKind::sphere;
  lamp.positionMm = {30.0, 10.0, 40.0};
  lamp.radiusMm = 5.0;
  lamp.power = glm::dvec3(3.0);
  LampLight second = lamp;
  second.kind = scene::LampKind::point;
  second.power = glm::dvec3(900.0);
  light.lamps = {lamp, second};
  const PathTracer tracer = tracerOf(light);
  std::vector<LightPoint> points;
  for (int i = 0; i < 300; ++i)
    points.push_back(
        pointAt(tracer, {-9.0 + i % 7, -8.0 + i % 11, -9.0 + i % 13}, static_cast<std::uint32_t>(i)));
  for (const LightPart part : {LightPart::sky, LightPart::lamps}) {
    for (const std::uint32_t count : {3u, 48u, 333u}) {
      std::vector<glm::vec3> together(points.size());
      std::uint64_t rays = 0, raysAlone = 0;
      ASSERT_TRUE(tracer.irradiance(part, points, {16, count}, together, {}, rays, {}));
      for (std::size_t i = 0; i < points.size(); ++i) {
        glm::vec3 alone;
        ASSERT_TRUE(tracer.irradiance(part, std::span(points).subspan(i, 1), {16, count},
                                      std::span(&alone, 1), {}, raysAlone, {}));
        EXPECT_EQ(alone, together[i]) << i;
      }
      EXPECT_EQ(rays, raysAlone);
    }
  }
}

// The mean of two ranges, weighted with their samples, is that of both, up to rounding.
TEST(PathTracerBounces, RangesAddUp) {
  LightScene light = cavity({0.7, 0.6, 0.5}, 3);
  LampLight lamp;
  lamp.positionMm = {3.0, 2.0, 1.0};
  lamp.power = glm::dvec3(200.0);
  light.lamps.push_back(lamp);
  const PathTracer tracer = tracerOf(light);
  const LightPoint point = pointAt(tracer, cavityRadius * wallDirection);
  const Estimate first = estimate(tracer, LightPart::lamps, point, 4);
  const Estimate rest = estimate(tracer, LightPart::lamps, point, 12, 4);
  const Estimate all = estimate(tracer, LightPart::lamps, point, 16);
  EXPECT_NEAR((first.luminance * 4 + rest.luminance * 12) / 16, all.luminance, 1e-5 * all.luminance);
}

TEST(PathTracerBounces, HardVolumesGiveNumbers) {
  std::vector<std::shared_ptr<const volume::PreparedVolume>> volumes;
  for (const char* name : {"noise", "two_balls", "sheet", "marschner_lobb"})
    volumes.push_back(test::phantom(name, 20));
  const auto formula = [&](glm::ivec3 dims, const Field& field) {
    volumes.push_back(volumeOf(GridGeometry::make(dims, {0.4, 0.4, 5.0}), field));
  };
  formula({12, 12, 12}, [](glm::dvec3) { return 1.0; });
  formula({12, 12, 1}, [](glm::dvec3 p) { return p.x; });
  formula({2, 12, 2}, [](glm::dvec3 p) { return p.y; });
  formula({12, 12, 12}, [](glm::dvec3 p) { return 1e-20 * std::sin(9.0 * p.x) * p.y; });
  formula({12, 12, 12}, [](glm::dvec3 p) { return 1e6 + std::sin(9.0 * p.x) * p.y; });
  formula({12, 12, 12}, [](glm::dvec3 p) { return 1e30 * std::sin(9.0 * p.x) * std::cos(p.y); });
  formula({12, 12, 12}, [](glm::dvec3 p) {
    return std::fmod(std::abs(17.0 * p.x + 31.0 * p.y + 7.0 * p.z), 3.0) < 0.3 ? NAN
                                                                               : p.x + std::cos(5.0 * p.y);
  });
  for (std::size_t v = 0; v < volumes.size(); ++v) {
    LightScene light = lightSceneOf(volumes[v], scene::Inside::above, glm::dvec3(0.9));
    light.environment = environmentOf(16, 8, [](glm::dvec3 d) { return d.z > 0.9 ? 1e5 : 1e-3; });
    light.environmentShare = 0.5;
    light.bounces = 20;
    LampLight lamp;
    lamp.positionMm = {2.0, 2.0, 20.0};
    lamp.power = glm::dvec3(100.0);
    light.lamps = {lamp};
    const PathTracer tracer = tracerOf(light);
    const volume::Grid& grid = volumes[v]->grid();
    for (int i = 0; i < 60; ++i) {
      const glm::dvec3 voxel =
          glm::dvec3(grid.dims() - 1) * glm::dvec3(i % 4 / 3.0, i % 5 / 4.0, i % 6 / 5.0);
      const LightPoint point =
          pointAt(tracer, glm::dvec3(grid.geometry().worldFromVoxel * glm::dvec4(voxel, 1.0)));
      if (point.normal == glm::vec3(0.0f)) continue;
      ASSERT_NEAR(glm::length(point.normal), 1.0f, 1e-4f);
      for (const LightPart part : {LightPart::sky, LightPart::lamps}) {
        const Estimate e = estimate(tracer, part, point, 32);
        ASSERT_TRUE(std::isfinite(e.luminance) && e.luminance >= 0.0) << v << ' ' << i;
        ASSERT_TRUE(std::isfinite(e.standardError));
      }
    }
  }
}

TEST(PathTracerBounces, StopsWhenAsked) {
  const PathTracer tracer = tracerOf(cavity(glm::dvec3(1.0), 1000));
  const LightPoint point = pointAt(tracer, cavityRadius * wallDirection);
  std::stop_source source;
  source.request_stop();
  glm::vec3 mean;
  std::uint64_t rays = 0;
  EXPECT_FALSE(tracer.irradiance(LightPart::lamps, std::span(&point, 1), {0, 1000}, std::span(&mean, 1), {},
                                 rays, source.get_token()));
}

}  // namespace
}  // namespace isolux::gi
