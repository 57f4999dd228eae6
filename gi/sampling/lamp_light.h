// States a light source in physical units.
#pragma once

#include <glm/vec3.hpp>

#include "scene/choices.h"

namespace isolux::gi {

// A light source in physical units, scaled so that E = pi * intensity * color on an unoccluded surface at the
// volume's centre that faces it.
struct LampLight {
  scene::LampKind kind = scene::LampKind::point;
  glm::dvec3 positionMm{0.0};
  double radiusMm = 0.0;             // sphere
  glm::dvec3 toward{0.0, 0.0, 1.0};  // directional: unit, world
  double cosHalfAngle = 1.0;         // directional: of the disc in the sky; 1 is a point
  // point: radiant intensity, mm^2 * radiance; sphere: radiance; directional: irradiance of a surface that
  // faces it if cosHalfAngle is 1, else radiance of the disc.
  glm::dvec3 power{0.0};
  bool shadows = true;  // the surface occludes its direct light
};

}  // namespace isolux::gi
