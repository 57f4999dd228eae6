// What stored light depends on, as text: tells whether a lattice or a file still fits a scene.
#pragma once

#include <string>

#include "gi/light_scene.h"

namespace isolux::gi {

// JSON of all that the stored light of the sky or of the lamps depends on, and of nothing else: equal keys,
// equal light. Number of samples, view, look, exposure and what lights the other lattice are not in it.
std::string lightKey(const scene::Scene& resolved, const LightScene& light, LightPart part);

}  // namespace isolux::gi
