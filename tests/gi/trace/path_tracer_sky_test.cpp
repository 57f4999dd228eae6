// Light of the sky without bounces, against closed forms.
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "tests/gi/light_fixture.h"
#include "tests/support/analytic_fields.h"
#include "tests/support/volumes.h"

namespace isolux::gi {
namespace {

using namespace isolux::test;
using volume::GridGeometry;

using std::numbers::pi;

// Inside is below the plane through the origin.
Field halfSpace(glm::dvec3 normal) {
  return [normal](glm::dvec3 p) { return -glm::dot(normal, p); };
}

TEST(PathTracerSky, APlaneUnderAConstantSkyGetsPiExactly) {
  LightScene light = lightSceneOf(volumeOf(cube(24), halfSpace(glm::normalize(glm::dvec3(0.3, -0.5, 0.8)))));
  setUnitSky(light);
  const PathTracer tracer = tracerOf(std::move(light));
  const Estimate e = estimate(tracer, LightPart::sky, pointAt(tracer, {0.3, 0.2, -0.4}), 1000);
  EXPECT_NEAR(e.luminance, pi, 1e-5);
  EXPECT_LT(e.standardError, 1e-7);
  EXPECT_EQ(e.rays, 1000u);
}

TEST(PathTracerSky, AConvexBodyGetsPiEverywhere) {
  LightScene light = lightSceneOf(test::phantom("ball", 48));
  setUnitSky(light);
  light.bounces = 3;
  const PathTracer tracer = tracerOf(std::move(light));
  for (int i = 0; i < 40; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / 40.0, angle = 2.4 * i, around = std::sqrt(1.0 - z * z);
    const glm::dvec3 out(around * std::cos(angle), around * std::sin(angle), z);
    const glm::dvec3 centre =
        tracer.light().volume->grid().geometry().worldFromVoxel * glm::dvec4(23.5, 23.5, 23.5, 1.0);
    const Estimate e = estimate(tracer, LightPart::sky, pointAt(tracer, centre + 14.0 * out), 256);
    EXPECT_NEAR(e.luminance, pi, 1e-5) << i;
  }
}

// E = pi (1 + cos tilt) / 2 under a sky that is bright above the horizon only: Lambert's clipped disc.
TEST(PathTracerSky, AHalfBrightSkyLightsByTheTiltOfThePlane) {
  const auto sky = environmentOf(8, 2, [](glm::dvec3 d) { return d.z > 0.0 ? 1.0 : 0.0; });
  for (const double tilt : {0.0, 40.0, 90.0, 130.0, 179.0}) {
    const double angle = tilt * pi / 180.0;
    const glm::dvec3 normal(std::sin(angle) * 0.6, std::sin(angle) * 0.8, std::cos(angle));
    LightScene light = lightSceneOf(volumeOf(cube(16), halfSpace(normal)));
    light.environment = sky;
    for (const double share : {0.0, 0.5}) {
      light.environmentShare = share;
      const PathTracer tracer = tracerOf(light);
      EXPECT_TRUE(agrees(estimate(tracer, LightPart::sky, pointAt(tracer, glm::dvec3(0.0)), 20000),
                         pi * (1.0 + std::cos(angle)) / 2.0))
          << tilt << " degrees, share " << share;
    }
  }
}

// The same with the sky turned instead of the plane.
TEST(PathTracerSky, TheEnvironmentTurns) {
  LightScene light = lightSceneOf(volumeOf(cube(16), halfSpace({0.0, 0.0, 1.0})));
  light.environment = environmentOf(8, 2, [](glm::dvec3 d) { return d.z > 0.0 ? 1.0 : 0.0; });
  light.environmentShare = 0.5;
  const double angle = 50.0 * pi / 180.0;
  light.worldFromEnvironment =
      glm::mat3(worldFromEnvironment({std::cos(angle / 2.0), std::sin(angle / 2.0), 0.0, 0.0}));
  const PathTracer tracer = tracerOf(light);
  EXPECT_TRUE(agrees(estimate(tracer, LightPart::sky, pointAt(tracer, glm::dvec3(0.0)), 20000),
                     pi * (1.0 + std::cos(angle)) / 2.0));
}

// A ball hides (R / d)^2 cos of the cosine-weighted sky (Howell, factor B-44), seen from where rays start.
TEST(PathTracerSky, ABallOverAPlaneHidesItsFormFactor) {
  const double radius = 9.0;
  const glm::dvec3 centre(1.0, -2.0, 14.0);
  const Field field = [&](glm::dvec3 p) { return std::max(-p.z - 10.0, radius - glm::length(p - centre)); };
  const GridGeometry geometries[] = {
      cube(64), GridGeometry::make({80, 64, 40}, {0.8, 1.0, 1.6}, {-31.6, -31.5, -31.2}),
      GridGeometry::make({96, 96, 96}, {0.7, 0.7, 0.7}, {52.0, -30.0, -46.0},
                         glm::dmat3(-0.8, 0.6, 0.0, 0.48, 0.64, 0.6, -0.36, -0.48, 0.8))};
  for (const GridGeometry& geometry : geometries) {
    LightScene light = lightSceneOf(volumeOf(geometry, field));
    setUnitSky(light);
    const PathTracer tracer = tracerOf(std::move(light));
    for (const glm::dvec2& at : {glm::dvec2(1.0, -2.0), glm::dvec2(9.0, 1.0), glm::dvec2(-12.0, -7.0)}) {
      const LightPoint point = pointAt(tracer, {at.x, at.y, -10.0});
      const glm::dvec3 toward = centre - rayOrigin(tracer, point);
      const double d = glm::length(toward);
      const double hidden = radius * radius / (d * d) * toward.z / d;
      EXPECT_TRUE(agrees(estimate(tracer, LightPart::sky, point, 20000), pi * (1.0 - hidden)))
          << geometry.dims.x << ' ' << at.x;
    }
  }
}

// From the axis of a well of radius a, h below its mouth, the sky is a disc: a^2 / (a^2 + h^2).
TEST(PathTracerSky, AWellShowsTheSkyAsADisc) {
  const double radius = 15.0;
  const GridGeometry geometry = cube(48);  // its upper border is the mouth: z = 23.5
  LightScene light =
      lightSceneOf(volumeOf(geometry, [&](glm::dvec3 p) { return std::hypot(p.x, p.y) - radius; }));
  setUnitSky(light);
  const PathTracer tracer = tracerOf(std::move(light));
  for (const double depth : {5.0, 20.0, 40.0}) {
    LightPoint point;
    point.voxel = {23.5f, 23.5f, static_cast<float>(47.0 - depth)};
    point.normal = {0.0f, 0.0f, 1.0f};
    const double h = 23.5 - rayOrigin(tracer, point).z;
    EXPECT_TRUE(agrees(estimate(tracer, LightPart::sky, point, 20000),
                       pi * radius * radius / (radius * radius + h * h)))
        << depth;
  }
}

// Irradiance of the open plane z = 0, by sums over parts of pixels.
double openIrradiance(const Environment& environment) {
  constexpr int parts = 32;
  double sum = 0.0;
  for (int row = 0; row < environment.height() * parts; ++row)
    for (int column = 0; column < environment.width() * parts; ++column) {
      const glm::dvec3 d = environment.directionOf((column + 0.5) / parts, (row + 0.5) / parts);
      const double sine = std::hypot(d.x, d.y);
      const double area =
          pi / (environment.height() * parts) * 2.0 * pi / (environment.width() * parts) * sine;
      sum += static_cast<double>(environment.radiance(glm::vec3(d)).x) * std::max(0.0, d.z) * area;
    }
  return sum;
}

TEST(PathTracerSky, EveryShareOfTheEnvironmentGivesTheSameLightUnderASun) {
  const auto sky = environmentOf(64, 32, [](glm::dvec3 d) {
    return glm::dot(d, glm::normalize(glm::dvec3(0.5, 0.3, 0.7))) > 0.998 ? 1e5 : 1e-3;
  });
  LightScene light = lightSceneOf(volumeOf(cube(16), halfSpace({0.0, 0.0, 1.0})));
  light.environment = sky;
  const double expected = openIrradiance(*sky);
  double first = 0.0;
  for (const double share : {0.0, 0.25, 0.5, 0.9}) {
    light.environmentShare = share;
    const PathTracer tracer = tracerOf(light);
    const Estimate e = estimate(tracer, LightPart::sky, pointAt(tracer, glm::dvec3(0.0)), 40000);
    EXPECT_TRUE(agrees(e, expected)) << share;
    if (share == 0.0) first = e.standardError;
    if (share > 0.0) {
      EXPECT_LT(e.standardError, 0.2 * first) << share;
    }
  }
}

TEST(PathTracerSky, AllSequencesGiveTheSameLight) {
  LightScene light = lightSceneOf(test::phantom("gyroid", 48));
  light.environment = environmentOf(16, 8, [](glm::dvec3 d) { return 1.0 + d.x + (d.z > 0.3 ? 3.0 : 0.0); });
  light.environmentShare = 0.3;
  light.bounces = 2;
  Estimate estimates[3];
  int i = 0;
  for (const scene::DirectionSequence sequence :
       {scene::DirectionSequence::random, scene::DirectionSequence::sobol_owen,
        scene::DirectionSequence::r2}) {
    light.sequence = sequence;
    const PathTracer tracer = tracerOf(light);
    estimates[i++] = estimate(tracer, LightPart::sky, pointAt(tracer, {3.3, -2.1, 5.2}, 77), 20000);
  }
  EXPECT_TRUE(agree(estimates[0], estimates[1]));
  EXPECT_TRUE(agree(estimates[0], estimates[2]));
}

TEST(PathTracerSky, ABlackSkyGivesNothingAndTracesNothing) {
  LightScene light = lightSceneOf(test::phantom("gyroid", 24));
  light.environment = environmentOf(8, 4, [](glm::dvec3) { return 0.0; });
  light.environmentShare = 0.5;
  const PathTracer tracer = tracerOf(light);
  const Estimate e = estimate(tracer, LightPart::sky, pointAt(tracer, glm::dvec3(0.0)), 100);
  EXPECT_EQ(e.mean, glm::dvec3(0.0));
  EXPECT_EQ(e.rays, 0u);
}

}  // namespace
}  // namespace isolux::gi
