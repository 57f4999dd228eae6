// Lists the isosurfaces that a scene shows: the first, and the further ones that are switched on.
#pragma once

#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace isolux::scene {

// The settings that Isosurface and ExtraIsosurface have in common.
struct ShownSurface {
  std::optional<double> value;  // data units; known in a resolved scene
  glm::dvec3 albedo;            // of the surface itself, without isosurface.albedo_source
  double specular, roughness;
  double opacity, facingOpacity;
  bool clipped;
};

// Returns the first surface first, surfaces of opacity 0 included.
std::vector<ShownSurface> shownSurfaces(const Scene& scene);
// Returns those of opacity above 0.
std::vector<ShownSurface> visibleSurfaces(const Scene& scene);

}  // namespace isolux::scene
