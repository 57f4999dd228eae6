#include "gi/picture_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/color.h"
#include "base/portable_math.h"
#include "gi/harmonics/sh_rotation.h"
#include "gi/harmonics/spherical_harmonics.h"

namespace isolux::gi {

namespace {

constexpr int localOrder = 3;  // Ramamoorthi & Hanrahan 2001: irradiance is of nine numbers to 1 %

std::vector<glm::dvec3> rotated(const std::vector<glm::dvec3>& coefficients, int order,
                                const glm::dmat3& rotation) {
  std::vector<glm::dvec3> result(coefficients.size());
  ShRotation(order, rotation).apply(coefficients, result);
  return result;
}

// A white surface in the open that faces where most light comes from is just white.
float exposureFor(const PictureLight& light, const scene::Scene& resolved) {
  constexpr int directions = 200;
  constexpr double mostStops = 40.0, golden = 2.399963229728653;  // radians: a spiral over the sphere
  double brightest = 0.0;
  for (int i = 0; i < directions; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / directions, r = std::sqrt(1.0 - z * z);
    const glm::dvec3 normal(r * base::portableCos(golden * i), r * base::portableSin(golden * i), z);
    double basis[9];
    evaluateSh(localOrder, normal, basis);
    glm::dvec3 irradiance(0.0);
    for (std::size_t k = 0; k < 9; ++k) irradiance += basis[k] * glm::dvec3(light.irradianceSh[k]);
    brightest = std::max(brightest, base::luminance(irradiance) / std::numbers::pi);
  }
  for (const scene::Lamp& lamp : resolved.lamps)
    if (lamp.shown) brightest += lamp.intensity * base::luminance(lamp.color);
  if (!(brightest > 0.0)) return 0.0f;
  return static_cast<float>(std::clamp(-std::log2(brightest), -mostStops, mostStops));
}

}  // namespace

PictureLight makePictureLight(const scene::Scene& resolved, const LightScene& light,
                              const EnvironmentProjection& projection) {
  const scene::Environment& settings = resolved.light.environment;
  const double exposure = std::exp2(settings.exposure);
  const glm::dmat3 rotation = rotationOf(resolved, *light.volume);
  const glm::dvec3 mean = light.environment->mean();

  PictureLight result;
  result.grid = light.volume->volume.grid;
  result.samplesWanted = static_cast<std::uint32_t>(resolved.gi.samples);
  result.skyScale = glm::vec3(exposure * (light.choice.unitSky ? mean : glm::dvec3(1.0)));
  if (light.choice.sky == scene::GiMode::transfer) {
    std::vector<glm::dvec3> coefficients = rotated(projection.transfer, light.shOrder, rotation);
    windowSh(light.shOrder, resolved.gi.shWindow, coefficients);
    for (const glm::dvec3& c : coefficients) result.environment.emplace_back(exposure * c);
  }

  std::vector<glm::dvec3> local(shTerms(localOrder), glm::dvec3(0.0));
  local[0] = mean * std::sqrt(4.0 * std::numbers::pi);
  if (!light.choice.unitSky) local = rotated(projection.local, localOrder, rotation);
  for (int l = 0, i = 0; l < localOrder; ++l)
    for (; i < shTerms(l + 1); ++i)
      result.irradianceSh[static_cast<std::size_t>(i)] =
          glm::vec3(exposure * clampedCosine(l) * local[static_cast<std::size_t>(i)]);
  result.lampLights = light.lamps;

  if (settings.visible) result.background = light.environment;
  result.environmentFromWorld = glm::mat3(glm::transpose(rotation));
  result.backgroundScale = static_cast<float>(exposure);

  result.automaticExposure = exposureFor(result, resolved);
  for (const scene::Lamp& lamp : resolved.lamps)
    if (lamp.shown)
      result.lampsIrradiance +=
          static_cast<float>(std::numbers::pi * lamp.intensity * base::luminance(lamp.color));
  return result;
}

EnvironmentProjection projectEnvironment(const Environment& environment, int order) {
  return {environment.project(order), environment.project(localOrder)};
}

}  // namespace isolux::gi
