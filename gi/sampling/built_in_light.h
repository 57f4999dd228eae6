// The built-in lights: radiance as formulas of direction, drawn once into the image that the environment
// samples.
//
// In the environment's own frame (gi/sampling/environment.h): +z up, and who looks at the volume's front
// stands at -y and looks to +y, with +x to the right. So the main light of each comes from the viewer's upper
// left.
#pragma once

#include <glm/vec3.hpp>

#include "gi/sampling/environment.h"
#include "scene/choices.h"

namespace isolux::gi {

// Goes up when a built-in light gives other radiances: what is stored under the old ones is then refused
// (gi/light_key.h).
inline constexpr int kBuiltInLightVersion = 1;

glm::dvec3 builtInRadiance(scene::BuiltInLight light, const glm::dvec3& direction);  // of a unit vector
Environment builtInEnvironment(scene::BuiltInLight light);

}  // namespace isolux::gi
