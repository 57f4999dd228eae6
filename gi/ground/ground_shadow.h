// Computes the shadow of the shown isosurfaces on the ground: a plane across scene::upOf() that touches their
// lowest point. Turning the environment does not tilt it.
//
// At points of the plane: the fraction of the unoccluded irradiance, in luminance, that reaches them from the
// sky and the light sources. Light that surfaces reflect is not included. A surface in the way dims a ray by
// its mean opacity (scene/opacity.h), whichever of its sides the ray meets. All points share one pattern of
// directions, so that the shadow has no noise. Where neighbouring points agree to 2 %, those between them are
// interpolated.
//
// A place on the ground has two coordinates in [-1, 1], 0 in the middle of the surfaces' footprint, ±1 at
// least twice its half width (and the surfaces' height) outside of it. From kFadesFrom on, the shadow fades;
// at distance 1 and beyond, the fraction is exactly 1. Immutable; safe from any thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/progress.h"
#include "gi/light_scene.h"
#include "scene/camera.h"

namespace isolux::gi {

struct GroundShadow {
  static constexpr int kPoints = 193;        // per axis
  static constexpr double kFadesFrom = 0.6;  // distance from the middle
  // Points are closer to each other in the middle: point i has the coordinate u / (1 + kCrowding (1 - |u|)),
  // u = 2 i / (kPoints - 1) - 1.
  static constexpr double kCrowding = 2.0;

  std::uint64_t key = 0;  // of all that the shadow depends on; never 0
  glm::dvec3 middleMm{0.0}, up{0.0, 0.0, 1.0};
  glm::dvec3 rightMm{1.0, 0.0, 0.0}, backMm{0.0, 1.0, 0.0};  // from the middle to the borders
  std::vector<float> light;                                  // fractions, row by row from place (-1, -1)

  float at(glm::dvec2 place) const;  // bilinear between the points
  // Returns a matrix M for points (x, y) of an image, in [-1, 1] and y up: (u, v, w) = M (x, y, 1). The ray
  // through the point meets the ground at place (u, v) / w if w > 0, else not at all. nullopt: the viewer is
  // not above the ground.
  std::optional<glm::dmat3> placesOf(const scene::CameraFrame& camera, double aspect) const;
};

// Returns null if the scene has no ground (gi.ground), no light or no surface. Returns `before`, which may be
// null, if it is the same. Requires the scene's tracer in `light` if any light is baked. Throws Error:
// interrupted; memory.
std::shared_ptr<const GroundShadow> makeGroundShadow(const scene::Scene& resolved, const LightScene& light,
                                                     const std::shared_ptr<const GroundShadow>& before,
                                                     base::Progress& progress);
// Returns GroundShadow::key of this scene; 0: it has no ground.
std::uint64_t groundKey(const scene::Scene& resolved, const LightScene& light);

}  // namespace isolux::gi
