// Gloss against closed forms: the lobe, environments filtered by it, lamps, and what stands in the way.
#include "gi/gloss/reflections.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/color.h"
#include "gi/picture_light.h"
#include "tests/gi/light_fixture.h"

namespace isolux::gi {
namespace {

using namespace isolux::test;
using std::numbers::pi;

constexpr float kRoughnesses[] = {0.1f, 0.3f, 0.6f, 1.0f};

// A point of the plane z = 0 seen from `toEye`.
GlossPoint planePoint(const PathTracer& tracer, glm::dvec3 toEye, float roughness, std::uint32_t seed = 1) {
  const LightPoint light = pointAt(tracer, glm::dvec3(0.0), seed);
  const glm::vec3 ray(-glm::normalize(toEye));
  GlossPoint point;
  point.voxel = light.voxel;
  point.isovalue = light.isovalue;
  point.normal = light.normal;
  point.mirror = ray - 2.0f * glm::dot(ray, light.normal) * light.normal;
  point.exponent = glossExponent(roughness);
  point.seed = seed;
  return point;
}

std::shared_ptr<const volume::PreparedVolume> glossyPlane() {
  return volumeOf(cube(24), [](glm::dvec3 p) { return -p.z; });
}

Estimate radianceOf(const PathTracer& tracer, const GlossPoint& point, std::uint32_t samples) {
  RadianceSum sum;
  Estimate result;
  EXPECT_TRUE(reflectedRadiance(tracer, std::span(&point, 1), {0, samples}, 1.0, std::span(&sum, 1),
                                result.rays, {}));
  result.mean = (sum.sky + sum.lamps) / static_cast<double>(samples);
  result.luminance = base::luminance(result.mean);
  const double variance = (sum.squares - sum.luminance * sum.luminance / samples) / (samples - 1.0);
  result.standardError = std::sqrt(std::max(variance, 0.0) / samples);
  return result;
}

// Over 1 + z, a lobe cos^k about the mirror direction r gives 1 + (k + 1) / (k + 2) r.z.
TEST(FilteredEnvironment, IsTheIntegralWithTheLobe) {
  const auto sky = environmentOf(256, 128, [](glm::dvec3 d) { return 1.0 + d.z; });
  for (const float roughness : kRoughnesses) {
    SCOPED_TRACE(roughness);
    const FilteredEnvironment environment(*sky, roughness);
    const Environment& map = environment.filtered();
    const double exponent = static_cast<double>(glossExponent(roughness));
    for (int row = 0; row < map.height(); row += 3) {
      const glm::dvec3 direction = map.directionOf(0.5, row + 0.5);
      const auto found = static_cast<double>(map.pixels()[static_cast<std::size_t>(row * map.width())].x);
      EXPECT_NEAR(found, 1.0 + (exponent + 1.0) / (exponent + 2.0) * direction.z, 0.01);
    }
  }
}

TEST(FilteredEnvironment, KeepsTheMeanOfABrightSpot) {
  const auto sky = environmentOf(512, 256, [](glm::dvec3 d) { return d.x > 0.995 ? 1000.0 : 1.0; });
  for (const float roughness : kRoughnesses) {
    const FilteredEnvironment environment(*sky, roughness);
    EXPECT_NEAR(environment.coarse().mean().x / sky->mean().x, 1.0, 0.02) << roughness;
    EXPECT_NEAR(environment.filtered().mean().x / sky->mean().x, 1.0, 0.04) << roughness;
  }
}

TEST(Gloss, DirectionsHaveTheDensityOfTheLobe) {
  const glm::vec3 mirror = glm::normalize(glm::vec3(0.3f, -0.5f, 0.8f));
  for (const float roughness : kRoughnesses) {
    const float exponent = glossExponent(roughness);
    double sum = 0.0;  // of the cosine: (k + 1) / (k + 2)
    constexpr std::uint32_t samples = 20000;
    for (std::uint32_t i = 0; i < samples; ++i)
      sum += static_cast<double>(glm::dot(
          mirror, lobeDirection(mirror, exponent, samplePair(scene::DirectionSequence::r2, 1, i, 0))));
    const auto k = static_cast<double>(exponent);
    EXPECT_NEAR(sum / samples, (k + 1.0) / (k + 2.0), 2e-4) << roughness;
    double all = 0.0;
    constexpr int steps = 200000;
    for (int i = 0; i < steps; ++i) {
      const double cosine = (i + 0.5) / steps;
      all += 2.0 * pi / steps * static_cast<double>(lobeDensity(exponent, static_cast<float>(cosine)));
    }
    EXPECT_NEAR(all, 1.0, 2e-3) << roughness;
  }
}

// Every ray escapes to the same radiance, also those mirrored at the tangent plane: no noise.
TEST(Gloss, AUniformSkyIsReflectedWhole) {
  LightScene light = lightSceneOf(glossyPlane());
  light.environment = std::make_shared<const Environment>(Environment::constant(glm::dvec3(2.0)));
  const PathTracer tracer = tracerOf(std::move(light));
  for (const float roughness : kRoughnesses)
    for (const double height : {10.0, 0.1}) {
      const glm::dvec3 eye(1.0, 0.5, height);
      const Estimate found = radianceOf(tracer, planePoint(tracer, eye, roughness), 64);
      EXPECT_NEAR(found.luminance, 2.0, 1e-6);
      EXPECT_NEAR(found.standardError, 0.0, 1e-6);
    }
}

// Below the horizon the sky is 1 - z in the lobe: what it holds there comes from above, mirrored.
TEST(Gloss, ASkyThatBrightensUpwards) {
  LightScene light = lightSceneOf(glossyPlane());
  light.environment = environmentOf(512, 256, [](glm::dvec3 d) { return 1.0 + d.z; });
  const PathTracer tracer = tracerOf(std::move(light));
  for (const float roughness : {0.1f, 0.3f}) {  // nothing of the lobe is below
    const double k = static_cast<double>(glossExponent(roughness));
    const Estimate found =
        radianceOf(tracer, planePoint(tracer, glm::dvec3(0.5, 0.0, 0.8), roughness), 20000);
    const double up = 0.8 / std::hypot(0.5, 0.8);
    Estimate judged = found;
    judged.standardError = std::hypot(found.standardError, 2e-3);  // of the pixels of the sky
    EXPECT_TRUE(agrees(judged, 1.0 + (k + 1.0) / (k + 2.0) * up)) << roughness;
  }
  // A uniform lobe, straight above: 1 + 1/2.
  EXPECT_TRUE(agrees(radianceOf(tracer, planePoint(tracer, {0.0, 0.0, 1.0}, 1.0f), 20000), 1.5));
}

TEST(Gloss, APointLampShinesByTheDensityOfTheLobe) {
  LightScene light = lightSceneOf(glossyPlane());
  LampLight lamp;
  lamp.positionMm = glm::dvec3(6.0, 0.0, 8.0);
  lamp.power = glm::dvec3(50.0);
  light.lamps = {lamp};
  const PathTracer tracer = tracerOf(std::move(light));
  for (const float roughness : {0.3f, 0.6f}) {
    const glm::dvec3 eye = glm::normalize(glm::dvec3(-0.5, 0.1, 0.8));
    const double cosine = glm::dot(glm::dvec3(-eye.x, -eye.y, eye.z), glm::dvec3(0.6, 0.0, 0.8));
    const double k = static_cast<double>(glossExponent(roughness));
    const double wanted = 50.0 / 100.0 * (k + 1.0) / (2.0 * pi) * std::pow(cosine, k);
    EXPECT_NEAR(radianceOf(tracer, planePoint(tracer, eye, roughness), 4).luminance, wanted, 2e-3 * wanted);
  }
}

// A ball of radius R at height h over the plane, straight above a point that is seen from above, hides the
// cone of half angle asin(R / h): of the lobe 1 - cos^(k + 1) of it. The ball is black.
TEST(Gloss, ABallAboveHidesItsConeOfTheSky) {
  constexpr double radius = 6.0, height = 14.0;
  const auto volume = volumeOf(cube(56), [](glm::dvec3 p) {
    return std::max(-p.z, radius - glm::length(p - glm::dvec3(0.0, 0.0, height)));
  });
  LightScene light = lightSceneOf(volume, scene::Inside::above, glm::dvec3(0.0));
  light.environment = std::make_shared<const Environment>(Environment::constant(glm::dvec3(1.0)));
  const auto scene = std::make_shared<const LightScene>(light);
  const PathTracer tracer(scene);
  const double cosine = std::sqrt(1.0 - radius * radius / (height * height));
  for (const float roughness : {0.4f, 0.6f, 1.0f}) {
    SCOPED_TRACE(roughness);
    GlossPoint point = planePoint(tracer, {0.0, 0.0, 1.0}, roughness);
    const double wanted = std::pow(cosine, static_cast<double>(point.exponent) + 1.0);
    Estimate found = radianceOf(tracer, point, 20000);
    found.standardError += 3e-3;  // of a ball of voxels
    EXPECT_TRUE(agrees(found, wanted));

    // The frame's estimate is the same part of the filtered environment.
    auto gloss = std::make_shared<GlossLight>();
    gloss->scene = scene;
    gloss->environments = {std::make_shared<const FilteredEnvironment>(*scene->environment, roughness)};
    PictureLight picture;
    picture.gloss = gloss;
    point.environment = gloss->of(roughness).get();
    Reflection reflection;
    ASSERT_TRUE(reflectionsOf(picture, std::span(&point, 1), 4096, std::span(&reflection, 1), {}));
    EXPECT_NEAR(static_cast<double>(reflection.visible / reflection.open), wanted, 0.02);
    EXPECT_NEAR(static_cast<double>(reflection.met), 1.0 - wanted, 0.02);
  }
}

// The same ball, grey, under a sky without shadows: all of the sky, and what the ball reflects of it (1/2
// without bounces). A lamp behind the ball shines through without shadows.
TEST(Gloss, WithoutShadowsNothingIsHidden) {
  constexpr double radius = 6.0, height = 14.0;
  const auto volume = volumeOf(cube(56), [](glm::dvec3 p) {
    return std::max(-p.z, radius - glm::length(p - glm::dvec3(0.0, 0.0, height)));
  });
  LightScene light = lightSceneOf(volume, scene::Inside::above, glm::dvec3(0.5));
  light.environment = std::make_shared<const Environment>(Environment::constant(glm::dvec3(1.0)));
  light.skyShadows = false;
  LampLight lamp;
  lamp.positionMm = {0.0, 0.0, 25.0};
  lamp.power = glm::dvec3(50.0);
  const double cosine = std::sqrt(1.0 - radius * radius / (height * height));
  for (const bool shadows : {true, false})
    for (const float roughness : {0.4f, 1.0f}) {
      SCOPED_TRACE(roughness);
      lamp.shadows = shadows;
      light.lamps = {lamp};
      const auto scene = std::make_shared<const LightScene>(light);
      const PathTracer tracer(scene);
      GlossPoint point = planePoint(tracer, {0.0, 0.0, 1.0}, roughness);
      const double k = static_cast<double>(point.exponent), hidden = 1.0 - std::pow(cosine, k + 1.0);
      // The lamp shines on the upper side of the ball only: the side that is reflected faces away, and the
      // lamp without shadows lights what faces it.
      const double ofLamp = shadows ? 0.0 : 50.0 / 625.0 * (k + 1.0) / (2.0 * pi);
      Estimate found = radianceOf(tracer, point, 20000);
      found.standardError += 3e-3;
      EXPECT_TRUE(agrees(found, 1.0 + 0.5 * hidden + ofLamp));

      auto gloss = std::make_shared<GlossLight>();
      gloss->scene = scene;
      gloss->environments = {std::make_shared<const FilteredEnvironment>(*scene->environment, roughness)};
      PictureLight picture;  // stores no light: of the surface, the unoccluded is seen
      picture.irradianceSh[0] = glm::vec3(static_cast<float>(pi * std::sqrt(4.0 * pi)));
      picture.gloss = gloss;
      point.environment = gloss->of(roughness).get();
      Reflection reflection;
      ASSERT_TRUE(reflectionsOf(picture, std::span(&point, 1), 4096, std::span(&reflection, 1), {}));
      EXPECT_FLOAT_EQ(reflection.visible, reflection.open);
      EXPECT_NEAR(static_cast<double>(reflection.met), hidden, 0.02);
      EXPECT_EQ(reflection.lamps[0], shadows ? 0.0f : 1.0f);
      EXPECT_NEAR(static_cast<double>(reflection.unoccluded.x), 0.5, 1e-3);
    }
}

}  // namespace
}  // namespace isolux::gi
