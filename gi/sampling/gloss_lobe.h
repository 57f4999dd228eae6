// Defines the gloss of a surface: one lobe about the mirror direction, over a diffuse part.
//
//   L = F R + (1 - F) albedo E / pi,   R = ∫ D(ω) L(ω') dω
//
// D is the normalised Phong lobe (k + 1) / (2 pi) cos^k of the angle to the mirror direction (Lafortune and
// Willems 1994). Its exponent is that of Blinn's halfway lobe for GGX roughness² over 4, k = (2 / r⁴ - 2)
// / 4. A direction ω below the surface is mirrored at the tangent plane to ω', so that no light is lost:
// under a uniform sky a white surface stays white. F is Schlick's approximation, less steep on rough surfaces
// (Lagarde 2011). After a reflection light meets diffuse surfaces: paths bounce by the albedo alone.
// resources/shaders/light/gloss.glsl computes the same.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "gi/sampling/directions.h"

namespace isolux::gi {

inline float glossExponent(float roughness) {
  const float square = roughness * roughness;
  return 0.5f / (square * square) - 0.5f;
}

// Returns F for the cosine between normal and view, in [0, 1].
inline float fresnel(float specular, float roughness, float cosine) {
  const float away = 1.0f - cosine, square = away * away;
  return specular + (std::max(1.0f - roughness, specular) - specular) * square * square * away;
}

// Samples D about a unit direction; u in [0, 1)^2.
inline glm::vec3 lobeDirection(glm::vec3 mirror, float exponent, glm::vec2 u) {
  const float cosine = std::pow(1.0f - u.y, 1.0f / (exponent + 1.0f));
  const float sine = std::sqrt(std::max(0.0f, (1.0f - cosine) * (1.0f + cosine)));
  float s, c;
  sineCosineOfTurn(u.x - 0.5f, s, c);
  return glm::normalize(Frame::about(mirror).toWorld({sine * c, sine * s, cosine}));
}

// Returns D, per steradian, for the cosine to the mirror direction.
inline float lobeDensity(float exponent, float cosine) {
  return cosine > 0.0f ? (exponent + 1.0f) * 0.5f * std::numbers::inv_pi_v<float> * std::pow(cosine, exponent)
                       : 0.0f;
}

// Returns ω' for a direction ω and the unit normal.
inline glm::vec3 abovePlane(glm::vec3 direction, glm::vec3 normal) {
  return direction - 2.0f * std::min(glm::dot(direction, normal), 0.0f) * normal;
}

}  // namespace isolux::gi
