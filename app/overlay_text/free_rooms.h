// Says which parts of a picture are left free by what is drawn over it: automatic views are fitted to these.
#pragma once

#include <glm/vec2.hpp>

#include "scene/framing.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

// Strips along the picture's sides, and at its top and bottom, in pixels.
struct Edges {
  double side = 0.0, end = 0.0;
};
// The rooms of a picture of this size that its letters, legend, scale bar and isovalues leave free: what
// automatic views are fitted to. `live`: what the window's own letters take at least. `overlayLegend`: how
// large the legend of an overlay becomes, beside the picture's own. Without any of it, and for
// views that frame the box (camera.frames=volume, sessions of before): all of the picture but `live`.
scene::Rooms freeRooms(const scene::Scene& resolved, const volume::PreparedVolume& volume, glm::ivec2 size,
                       const Edges& live = {}, glm::ivec2 overlayLegend = glm::ivec2(0));

}  // namespace isolux::app
