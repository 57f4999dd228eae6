// Light sources without shadows: closed forms of direct and reflected light, an independent estimate,
// transfer.
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "gi/harmonics/spherical_harmonics.h"
#include "gi/sampling/directions.h"
#include "tests/gi/light_fixture.h"
#include "tests/support/volumes.h"

namespace isolux::gi {
namespace {

using namespace isolux::test;
using std::numbers::pi;

constexpr double kClosedRadius = 20.0;
const glm::dvec3 kClosedWall = glm::normalize(glm::dvec3(0.36, -0.48, 0.8));

// Closed on all sides: with shadows, no light comes in.
LightScene closedCavity(glm::dvec3 albedo, int bounces) {
  LightScene light =
      lightSceneOf(volumeOf(cube(48), [](glm::dvec3 p) { return kClosedRadius - glm::length(p); }),
                   scene::Inside::below, albedo);
  light.bounces = bounces;
  light.rouletteDepth = 1000;
  return light;
}

double reflectedSeries(double albedo, int bounces) {  // albedo + albedo^2 + ...
  double sum = 0.0;
  for (int i = 1; i <= bounces; ++i) sum += std::pow(albedo, i);
  return sum;
}

TEST(UnshadowedLight, OfTheSkyWithoutBouncesIsPiEverywhereAndTracesNoRay) {
  LightScene light = lightSceneOf(test::phantom("gyroid", 40));
  setUnitSky(light);
  light.skyShadows = false;
  const PathTracer tracer = tracerOf(std::move(light));
  for (int i = 0; i < 30; ++i) {
    const LightPoint point = pointAt(tracer, {i % 7 - 3.0, i % 11 - 5.0, i % 13 - 6.0});
    if (point.normal == glm::vec3(0.0f)) continue;
    const Estimate e = estimate(tracer, LightPart::sky, point, 16);
    EXPECT_NEAR(e.luminance, pi, 1e-5);
    EXPECT_EQ(e.rays, 0u);
  }
}

// Every direction meets the wall: E = pi (1 + albedo + albedo^2 + ...), the same of every path.
TEST(UnshadowedLight, OfTheSkyInAClosedCavityIsTheGeometricSeries) {
  const glm::dvec3 albedo(0.8, 0.5, 0.1);
  for (const int bounces : {0, 1, 4}) {
    LightScene light = closedCavity(albedo, bounces);
    setUnitSky(light);
    light.skyShadows = false;
    const PathTracer tracer = tracerOf(std::move(light));
    const Estimate e = estimate(tracer, LightPart::sky, pointAt(tracer, kClosedRadius * kClosedWall), 64);
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(e.mean[channel], pi * (1.0 + reflectedSeries(albedo[channel], bounces)), 1e-4) << bounces;
    EXPECT_EQ(e.rays, 64u * static_cast<unsigned>(bounces));
  }
}

// A distant lamp outside: E0 = power max(0, n . toward), its mean over the wall is power / 4, and any part of
// a sphere sees all others alike.
TEST(UnshadowedLight, OfALampOutsideAClosedCavity) {
  LampLight lamp;
  lamp.kind = scene::LampKind::directional;
  lamp.toward = glm::normalize(glm::dvec3(-0.1, 0.9, -0.5));
  lamp.power = glm::dvec3(3.0);
  for (const bool shadows : {true, false})
    for (const int bounces : {0, 1, 3}) {
      LightScene light = closedCavity(glm::dvec3(0.6), bounces);
      lamp.shadows = shadows;
      light.lamps = {lamp};
      const PathTracer tracer = tracerOf(std::move(light));
      const LightPoint point = pointAt(tracer, kClosedRadius * kClosedWall);
      const Estimate e = estimate(tracer, LightPart::lamps, point, 20000);
      const double direct = 3.0 * std::max(0.0, glm::dot(glm::dvec3(point.normal), lamp.toward));
      EXPECT_GT(direct, 1.0);
      const double expected = shadows ? 0.0 : direct + 0.75 * reflectedSeries(0.6, bounces);
      EXPECT_TRUE(agrees(e, expected)) << shadows << ' ' << bounces;
    }
}

// A ball between a plane and two lamps of one place: only the light of the one without shadows comes through.
TEST(UnshadowedLight, OfALampBehindAnOccluder) {
  const auto volume = volumeOf(
      cube(56), [](glm::dvec3 p) { return std::max(-p.z, 6.0 - glm::length(p - glm::dvec3(0, 0, 14))); });
  LampLight lamp;
  lamp.positionMm = {0.0, 0.0, 30.0};
  lamp.power = glm::dvec3(100.0);
  for (const double radius : {0.0, 0.5}) {
    LightScene light = lightSceneOf(volume);
    lamp.kind = radius > 0.0 ? scene::LampKind::sphere : scene::LampKind::point;
    lamp.radiusMm = radius;
    lamp.power = glm::dvec3(radius > 0.0 ? 9.0 : 100.0);
    const double expected = radius > 0.0 ? pi * 9.0 * radius * radius / 900.0 : 100.0 / 900.0;
    light.lamps = {lamp, lamp};
    const auto lit = [&](bool first, bool second) {
      light.lamps[0].shadows = first;
      light.lamps[1].shadows = second;
      const PathTracer tracer = tracerOf(light);
      return estimate(tracer, LightPart::lamps, pointAt(tracer, glm::dvec3(0.0)), 4000);
    };
    EXPECT_EQ(lit(true, true).luminance, 0.0);
    EXPECT_TRUE(agrees(lit(true, false), expected)) << radius;
    EXPECT_TRUE(agrees(lit(false, true), expected)) << radius;
    EXPECT_TRUE(agrees(lit(false, false), 2.0 * expected)) << radius;
  }
}

// Under 1 + d.z / 2, an unoccluded surface has E(n) = pi (1 + n.z / 3). One bounce adds albedo times the mean
// of E(n) / pi over cosine-distributed rays that hit; the loop is this test's own.
TEST(UnshadowedLight, OfAnEnvironmentIsThatOfAnIndependentEstimate) {
  const auto openE = [](glm::dvec3 n) { return pi * (1.0 + n.z / 3.0); };
  LightScene light = lightSceneOf(test::phantom("gyroid", 48), scene::Inside::above, glm::dvec3(0.6));
  light.environment = environmentOf(128, 64, [](glm::dvec3 d) { return 1.0 + 0.5 * d.z; });
  light.skyShadows = false;
  for (const double share : {0.0, 0.5})
    for (const int bounces : {0, 1}) {
      light.environmentShare = share;
      light.bounces = bounces;
      const PathTracer tracer = tracerOf(light);
      const LightPoint point = pointAt(tracer, {3.2, -2.6, 5.1});
      constexpr std::uint32_t rays = 20000;
      double reflected = 0.0;
      for (std::uint32_t i = 0; bounces > 0 && i < rays; ++i) {
        const glm::vec3 direction =
            Frame::about(point.normal)
                .toWorld(cosineHemisphere(samplePair(scene::DirectionSequence::r2, 77, i, 0)));
        const volume::TraceRay ray{point.voxel + 0.1f * point.normal, direction, point.isovalue,
                                   std::numeric_limits<float>::infinity()};
        float t = 0.0f;
        light.tracer->firstEntries(std::span(&ray, 1), std::span(&t, 1));
        if (!std::isfinite(t)) continue;
        const glm::vec3 hit = ray.origin + t * direction;
        glm::vec3 gradient;
        light.tracer->gradients(std::span(&hit, 1), std::span(&gradient, 1));
        reflected += 0.6 * openE(glm::dvec3(tracer.normalOf(gradient))) / rays;
      }
      Estimate found = estimate(tracer, LightPart::sky, point, 40000);
      found.standardError = std::hypot(found.standardError, 2e-3);  // of the loop and the pixels of the sky
      EXPECT_TRUE(agrees(found, openE(glm::dvec3(point.normal)) + reflected)) << share << ' ' << bounces;
      EXPECT_TRUE(bounces == 0 || reflected > 0.3);
    }
}

// The directions of a path are many here. Sums must not depend on how samples are split among calls.
TEST(UnshadowedLight, TransferTimesEnvironmentIsIrradiance) {
  constexpr int order = 3;
  LightScene light = lightSceneOf(test::phantom("gyroid", 48), scene::Inside::above, {0.7, 0.6, 0.5});
  const auto sky = environmentOf(128, 64, [](glm::dvec3 d) { return 1.0 + 0.5 * d.z + 0.3 * d.x * d.y; });
  const std::vector<glm::dvec3> bands = sky->project(order);
  light.environment = sky;
  light.skyShadows = false;
  light.bounces = 3;
  light.shOrder = order;
  const PathTracer tracer = tracerOf(light);
  const LightPoint point = pointAt(tracer, {3.2, -2.6, 5.1}, 9);
  std::vector<double> whole(3 * shTerms(order), 0.0), parts = whole;
  std::uint64_t rays = 0;
  const auto add = [&](std::uint32_t first, std::uint32_t count, std::vector<double>& sums) {
    ASSERT_TRUE(tracer.addTransfer(std::span(&point, 1), {first, count}, sums, rays, {}));
  };
  constexpr std::uint32_t samples = 20000;
  add(0, samples, whole);
  add(0, 7, parts);
  add(7, 5000, parts);
  add(5007, samples - 5007, parts);
  EXPECT_EQ(whole, parts);
  const Estimate found = estimate(tracer, LightPart::sky, point, 40000);
  for (int channel = 0; channel < 3; ++channel) {
    double byTransfer = 0.0;
    for (int i = 0; i < shTerms(order); ++i)
      byTransfer +=
          whole[static_cast<std::size_t>(channel * shTerms(order) + i)] / samples * bands[i][channel];
    EXPECT_NEAR(found.mean[channel] / byTransfer, 1.0, 0.02) << channel;
  }
}

}  // namespace
}  // namespace isolux::gi
