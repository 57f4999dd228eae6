#include "tests/gi/light_fixture.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "base/color.h"
#include "gi/sampling/lamp_sampling.h"
#include "tests/support/volumes.h"
#include "volume/field/reconstruct.h"

namespace isolux::test {

namespace {

constexpr double zLimit = 4.5;

}  // namespace

std::shared_ptr<const volume::PreparedVolume> volumeOf(const volume::GridGeometry& geometry,
                                                       const Field& field) {
  return prepared(gridOfWorld(geometry, field));
}

volume::GridGeometry cube(int size) {
  return volume::GridGeometry::make(glm::ivec3(size), glm::dvec3(1.0), glm::dvec3(-0.5 * (size - 1)));
}

gi::LightScene lightSceneOf(std::shared_ptr<const volume::PreparedVolume> volume, scene::Inside inside,
                            glm::dvec3 albedo) {
  base::Progress progress;
  scene::Scene scene;
  scene.surfaces.front().value = 0.0;
  scene.surfaces.front().albedo = albedo;
  auto tracer = std::make_shared<const volume::IsosurfaceTracer>(volume->volume.grid, inside, progress);
  return {.volume = std::move(volume),
          .tracer = std::move(tracer),
          .choice = {},
          .environment = nullptr,
          .worldFromEnvironment = glm::mat3(1.0f),
          .lamps = {},
          .albedo = scene::AlbedoOfIsovalue(scene),
          .inside = inside,
          .sequence = scene::DirectionSequence::random,
          .bounces = 0,
          .rouletteDepth = 3,
          .environmentShare = 0.0,
          .shOrder = 5};
}

void setUnitSky(gi::LightScene& light) {
  light.choice.unitSky = true;
}

std::shared_ptr<const gi::Environment> environmentOf(int width, int height,
                                                     const std::function<double(glm::dvec3)>& radiance) {
  std::vector<glm::vec3> pixels;
  const gi::Environment black = gi::Environment(
      width, height, std::vector<glm::vec3>(static_cast<std::size_t>(width * height), glm::vec3(0.0f)));
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      pixels.emplace_back(static_cast<float>(radiance(black.directionOf(column + 0.5, row + 0.5))));
  return std::make_shared<const gi::Environment>(width, height, std::move(pixels));
}

gi::PathTracer tracerOf(gi::LightScene light) {
  return gi::PathTracer(std::make_shared<const gi::LightScene>(std::move(light)));
}

gi::LightPoint pointAt(const gi::PathTracer& tracer, glm::dvec3 world, std::uint32_t seed) {
  const volume::Grid& grid = tracer.light().volume->grid();
  const glm::dvec3 voxel(grid.geometry().voxelFromWorld() * glm::dvec4(world, 1.0));
  gi::LightPoint point;
  point.voxel = glm::vec3(voxel);
  point.isovalue = grid.storedIsovalue(volume::sampleTrilinear(grid, glm::dvec3(point.voxel)).value);
  glm::vec3 gradient;
  tracer.light().tracer->gradients(std::span(&point.voxel, 1), std::span(&gradient, 1));
  point.normal = tracer.normalOf(gradient);
  point.seed = seed;
  return point;
}

glm::dvec3 rayOrigin(const gi::PathTracer& tracer, const gi::LightPoint& point) {
  const volume::GridGeometry& geometry = tracer.light().volume->grid().geometry();
  const glm::dvec3 spacing = geometry.spacingMm();
  const double offset = gi::kOffsetVoxels * std::min({spacing.x, spacing.y, spacing.z});
  return glm::dvec3(geometry.worldFromVoxel * glm::dvec4(glm::dvec3(point.voxel), 1.0)) +
         offset * glm::dvec3(point.normal);
}

Estimate estimate(const gi::PathTracer& tracer, gi::LightPart part, const gi::LightPoint& point,
                  std::uint32_t samples, std::uint32_t first) {
  Estimate result;
  glm::vec3 mean;
  float variance = 0.0f;
  EXPECT_TRUE(tracer.irradiance(part, std::span(&point, 1), {first, samples}, std::span(&mean, 1),
                                std::span(&variance, 1), result.rays, {}));
  result.mean = glm::dvec3(mean);
  result.luminance = static_cast<double>(base::luminance(mean));
  result.standardError = std::sqrt(static_cast<double>(variance) / samples);
  return result;
}

::testing::AssertionResult agrees(const Estimate& estimate, double luminance) {
  const double apart = estimate.luminance - luminance;
  const double rounding = 1e-5 * std::abs(luminance);
  if (std::abs(apart) <= zLimit * estimate.standardError + rounding) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << estimate.luminance << " +- " << estimate.standardError << " where "
                                       << luminance << " is expected: z = " << apart / estimate.standardError;
}

::testing::AssertionResult agree(const Estimate& a, const Estimate& b) {
  Estimate difference = a;
  difference.luminance = a.luminance - b.luminance;
  difference.standardError = std::hypot(a.standardError, b.standardError);
  if (std::abs(difference.luminance) <= 1e-5 * std::abs(a.luminance)) return ::testing::AssertionSuccess();
  return agrees(difference, 0.0) << " (" << a.luminance << " against " << b.luminance << ")";
}

}  // namespace isolux::test
