// Provides the built-in environments: radiance as formulas of direction, evaluated once into the image that
// the environment samples.
//
// Directions are in the environment's own frame (gi/sampling/environment.h): +z is up. A viewer of the
// volume's front is at -y and looks towards +y, with +x to the right. The main light of each is at the
// viewer's upper left.
#pragma once

#include <glm/vec3.hpp>

#include "gi/sampling/environment.h"
#include "scene/choices.h"

namespace isolux::gi {

// Incremented when a built-in environment changes; light baked with older ones is then rejected
// (gi/light_key.h).
inline constexpr int kBuiltInLightVersion = 2;

glm::dvec3 builtInRadiance(scene::BuiltInLight light, const glm::dvec3& direction);  // requires a unit vector
Environment builtInEnvironment(scene::BuiltInLight light);

}  // namespace isolux::gi
