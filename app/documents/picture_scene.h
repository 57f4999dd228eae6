// What a picture carries of its scene.
#pragma once

#include "scene/scene.h"

namespace isolux::app {

// The scene as it was given, with the camera and the isovalues of what is shown from `resolved`. The rest
// stays automatic, so that whoever opens the picture finds what was chosen, and no more.
scene::Scene carriedScene(scene::Scene given, const scene::Scene& resolved);

}  // namespace isolux::app
