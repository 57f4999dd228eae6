// What a picture carries of its scene.
#pragma once

#include <optional>

#include "scene/scene.h"

namespace isolux::app {

// The scene as it was given, with the camera and the isovalues of what is shown from `resolved`, and with
// `exposure` if it was found by the view (exposureToCarry()). The rest stays automatic, so that whoever opens
// the picture finds what was chosen, and no more.
scene::Scene carriedScene(scene::Scene given, const scene::Scene& resolved,
                          std::optional<double> exposure = std::nullopt);

}  // namespace isolux::app
