#include "gi/sampling/lamp_sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/color.h"
#include "gi/sampling/directions.h"

namespace isolux::gi {

namespace {

constexpr float piFloat = std::numbers::pi_v<float>;

// Irradiance of a surface by radiance 1 from a cone whose axis has this cosine with the normal, as long as
// the cone is above the horizon; then a value that falls to 0 only when the whole cone is below.
float coneWeight(float cosine, float oneMinusCosine) {
  const float sine2 = oneMinusCosine * (2.0f - oneMinusCosine);
  const float sine = oneMinusCosine < 1.0f ? std::sqrt(std::max(0.0f, sine2)) : 1.0f;
  return piFloat * sine * sine * std::max(0.0f, (cosine + sine) / (1.0f + sine));
}

}  // namespace

LampSampler::LampSampler(std::span<const LampLight> lamps, const volume::GridGeometry& geometry)
    : mmOfVoxels_(geometry.worldFromVoxel) {
  nearestMm_ = static_cast<float>(1e-3 * geometry.leastSpacingMm());
  const glm::dmat4 voxelFromWorld = geometry.voxelFromWorld();
  for (const LampLight& light : lamps) {
    Lamp lamp{};
    lamp.kind = light.kind;
    lamp.shadows = light.shadows;
    lamp.voxel = glm::vec3(voxelFromWorld * glm::dvec4(light.positionMm, 1.0));
    lamp.toward = glm::vec3(light.toward);
    lamp.power = glm::vec3(light.power);
    lamp.luminance = base::luminance(lamp.power);
    lamp.radiusMm = static_cast<float>(light.radiusMm);
    lamp.oneMinusCosine = static_cast<float>(1.0 - light.cosHalfAngle);
    lamp.extended = lamp.kind == scene::LampKind::sphere ||
                    (lamp.kind == scene::LampKind::directional && light.cosHalfAngle < 1.0);
    if (lamp.luminance > 0.0f) lamps_.push_back(lamp);
  }
}

glm::vec3 LampSampler::mmTo(const Lamp& lamp, glm::vec3 voxel) const {
  return mmOfVoxels_ * (lamp.voxel - voxel);
}

LampSample LampSampler::sample(int index, glm::vec3 voxel, glm::vec3 normal, glm::vec2 u) const {
  const Lamp& lamp = lamps_[static_cast<std::size_t>(index)];
  if (lamp.kind == scene::LampKind::directional) {
    const glm::vec3 direction =
        lamp.extended ? Frame::about(lamp.toward).toWorld(uniformCone(u, lamp.oneMinusCosine)) : lamp.toward;
    const float weight = lamp.extended ? 2.0f * piFloat * lamp.oneMinusCosine : 1.0f;
    return {lamp.power * (weight * std::max(0.0f, glm::dot(normal, direction))), direction, true};
  }
  const glm::vec3 toCentre = mmTo(lamp, voxel);
  const float distance = glm::length(toCentre);
  if (lamp.kind == scene::LampKind::point) {
    if (!(distance > 0.0f)) return {};
    const float reach = std::max(distance, nearestMm_);
    const float cosine = glm::dot(normal, toCentre) / distance;
    return {lamp.power * (std::max(0.0f, cosine) / (reach * reach)), toCentre, false};
  }
  if (!(distance > lamp.radiusMm)) {  // inside: the same radiance from everywhere
    const glm::vec3 direction = Frame::about(normal).toWorld(cosineHemisphere(u));
    const float along = glm::dot(toCentre, direction);
    const float within = lamp.radiusMm * lamp.radiusMm - distance * distance;
    const float toSurface = along + std::sqrt(std::max(0.0f, along * along + within));
    return {piFloat * lamp.power, std::max(0.0f, toSurface) * direction, false};
  }
  const float open = oneMinusCosineOfBall(lamp.radiusMm, distance);
  const glm::vec3 local = uniformCone(u, open);
  const glm::vec3 direction = Frame::about(toCentre / distance).toWorld(local);
  // Where the ray meets the sphere. The sine comes from x and y: it keeps its digits in a narrow cone.
  const float sine2 = local.x * local.x + local.y * local.y;
  const float half = std::sqrt(std::max(0.0f, lamp.radiusMm * lamp.radiusMm - distance * distance * sine2));
  const float toSurface = std::max(0.0f, distance * local.z - half);
  const float cosine = std::max(0.0f, glm::dot(normal, direction));
  return {lamp.power * (2.0f * piFloat * open * cosine), toSurface * direction, false};
}

float LampSampler::brightness(const Lamp& lamp, glm::vec3 voxel, glm::vec3 normal) const {
  if (lamp.kind == scene::LampKind::directional) {
    const float cosine = glm::dot(normal, lamp.toward);
    return lamp.luminance *
           (lamp.extended ? coneWeight(cosine, lamp.oneMinusCosine) : std::max(0.0f, cosine));
  }
  const glm::vec3 toCentre = mmTo(lamp, voxel);
  const float distance = glm::length(toCentre);
  if (!(distance > 0.0f)) return lamp.extended ? piFloat * lamp.luminance : 0.0f;
  const float cosine = glm::dot(normal, toCentre) / distance;
  if (lamp.extended && !(distance > lamp.radiusMm)) return piFloat * lamp.luminance;
  if (lamp.extended)
    return lamp.luminance * coneWeight(cosine, oneMinusCosineOfBall(lamp.radiusMm, distance));
  const float reach = std::max(distance, nearestMm_);
  return lamp.luminance * std::max(0.0f, cosine) / (reach * reach);
}

int LampSampler::choose(glm::vec3 voxel, glm::vec3 normal, float u, float& probability) const {
  float sum = 0.0f;
  for (const Lamp& lamp : lamps_) sum += brightness(lamp, voxel, normal);
  if (!(sum > 0.0f) || !std::isfinite(sum)) return -1;
  float below = 0.0f;
  int chosen = -1;
  for (int i = 0; i < count(); ++i) {
    const float part = brightness(lamps_[static_cast<std::size_t>(i)], voxel, normal);
    if (!(part > 0.0f)) continue;
    chosen = i;  // the last one that shines, should rounding leave u above the sum
    probability = part / sum;
    below += part;
    if (u * sum < below) break;
  }
  return chosen;
}

}  // namespace isolux::gi
