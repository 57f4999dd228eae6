#include "gi/picture_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gi/sh_rotation.h"
#include "gi/spherical_harmonics.h"

namespace isolux::gi {

namespace {

constexpr int localOrder = 3;  // Ramamoorthi & Hanrahan 2001: irradiance is of nine numbers to 1 %

double luminance(const glm::dvec3& color) {
  return 0.2126 * color.x + 0.7152 * color.y + 0.0722 * color.z;
}

std::vector<glm::dvec3> rotated(const std::vector<glm::dvec3>& coefficients, int order,
                                const glm::dmat3& rotation) {
  std::vector<glm::dvec3> result(coefficients.size());
  ShRotation(order, rotation).apply(coefficients, result);
  return result;
}

}  // namespace

PictureLight makePictureLight(const scene::Scene& resolved, const LightScene& light,
                              const EnvironmentProjection& projection) {
  const scene::Environment& settings = resolved.light.environment;
  const double exposure = std::exp2(settings.exposure);
  const glm::dmat3 rotation = rotationOf(settings.rotation);
  const bool oneColor = light.choice.sky == scene::GiMode::vicinity;
  const glm::dvec3 mean = light.environment->mean();

  PictureLight result;
  result.samplesWanted = static_cast<std::uint32_t>(resolved.gi.samples);
  result.skyScale = glm::vec3(exposure * (light.choice.unitSky ? mean : glm::dvec3(1.0)));
  if (light.choice.sky == scene::GiMode::transfer) {
    std::vector<glm::dvec3> coefficients = rotated(projection.transfer, light.shOrder, rotation);
    windowSh(light.shOrder, resolved.gi.shWindow, coefficients);
    for (const glm::dvec3& c : coefficients) result.environment.emplace_back(exposure * c);
  }

  std::vector<glm::dvec3> local(shTerms(localOrder), glm::dvec3(0.0));
  local[0] = mean * std::sqrt(4.0 * std::numbers::pi);
  if (!oneColor) local = rotated(projection.local, localOrder, rotation);
  for (int l = 0, i = 0; l < localOrder; ++l)
    for (; i < shTerms(l + 1); ++i)
      result.irradianceSh[static_cast<std::size_t>(i)] =
          glm::vec3(exposure * clampedCosine(l) * local[static_cast<std::size_t>(i)]);
  result.lampLights = light.lamps;

  if (settings.visible) result.background = light.environment;
  result.environmentFromWorld = glm::mat3(glm::transpose(rotation));
  result.backgroundScale = static_cast<float>(exposure);

  // A lamp lights what faces it; the sky lights all alike.
  double brightness = exposure * luminance(mean);
  for (const scene::Lamp* lamp : {&resolved.lamp1, &resolved.lamp2, &resolved.lamp3})
    if (lamp->shown) brightness += 0.5 * lamp->intensity * luminance(lamp->color);
  constexpr double mostStops = 20.0;
  if (brightness > 0.0)
    result.automaticExposure = static_cast<float>(std::clamp(-std::log2(brightness), -mostStops, mostStops));
  return result;
}

EnvironmentProjection projectEnvironment(const Environment& environment, int order) {
  return {environment.project(order), environment.project(localOrder)};
}

}  // namespace isolux::gi
