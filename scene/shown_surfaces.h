// Lists the isosurfaces that a scene shows: the first, with an opacity of 0 if it is switched off, and the
// further ones that are switched on.
#pragma once

#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace isolux::scene {

// Returns the first surface first, surfaces of opacity 0 included.
std::vector<Surface> shownSurfaces(const Scene& scene);
// Returns those of opacity above 0.
std::vector<Surface> visibleSurfaces(const Scene& scene);

}  // namespace isolux::scene
