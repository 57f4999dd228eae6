// Volumes from formulas, light scenes around them, and verdicts on estimates of light.
//
// Estimates are judged by their own variance: |z| below 4.5, which a right estimator exceeds about once in
// 150 000 verdicts; seeds are fixed. An estimate without variance must agree to 1e-5 of the expected value.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "gi/trace/path_tracer.h"

namespace isolux::test {

using Field = std::function<double(glm::dvec3 world)>;

std::shared_ptr<const volume::PreparedVolume> volumeOf(const volume::GridGeometry& geometry,
                                                       const Field& field);
// Voxels of 1 mm round the world's origin.
volume::GridGeometry cube(int size);

// No sky, no lamps, no bounces, random numbers; members are there to be changed.
gi::LightScene lightSceneOf(std::shared_ptr<const volume::PreparedVolume> volume,
                            scene::Inside inside = scene::Inside::above, glm::dvec3 albedo = glm::dvec3(0.5));
void setUnitSky(gi::LightScene& light);
// An image of the environment, a formula of its own directions.
std::shared_ptr<const gi::Environment> environmentOf(int width, int height,
                                                     const std::function<double(glm::dvec3)>& radiance);

gi::PathTracer tracerOf(gi::LightScene light);

// A point of the isosurface through a world position, with the normal of the B-spline there.
gi::LightPoint pointAt(const gi::PathTracer& tracer, glm::dvec3 world, std::uint32_t seed = 1);
// The origin of its rays, world.
glm::dvec3 rayOrigin(const gi::PathTracer& tracer, const gi::LightPoint& point);

struct Estimate {
  glm::dvec3 mean{0.0};
  double luminance = 0.0, standardError = 0.0;  // of the mean's luminance
  std::uint64_t rays = 0;
};
Estimate estimate(const gi::PathTracer& tracer, gi::LightPart part, const gi::LightPoint& point,
                  std::uint32_t samples, std::uint32_t first = 0);

::testing::AssertionResult agrees(const Estimate& estimate, double luminance);
::testing::AssertionResult agree(const Estimate& a, const Estimate& b);

}  // namespace isolux::test
