// Describes the inputs of baked lighting as text, to test whether a lattice or a file still fits a scene.
#pragma once

#include <string>

#include "gi/light_scene.h"

namespace isolux::gi {

// Returns JSON of all inputs of the baked light of the sky or of the light sources: equal keys mean equal
// light. It excludes the number of samples, view, look, exposure and the lights of the other lattice.
std::string lightKey(const scene::Scene& resolved, const LightScene& light, LightPart part);

}  // namespace isolux::gi
