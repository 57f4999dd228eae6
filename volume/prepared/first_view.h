// From where a volume is looked at first.
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "scene/world_axes.h"
#include "volume/prepared/surface_outline.h"

namespace isolux::volume {

struct FirstView {
  glm::dvec3 toEye{0.0}, up{0.0};  // unit vectors, world
};

// A patient's portrait: from the front, 7 degrees above. Anything else in three quarters, 20 degrees above (a
// slab that lies: 55): of eight directions the one from which most of the surface and of its relief can be
// seen. Up is the habit of its axes, but where another side is much flatter it stands on that. Of many
// samples as surfaceOutline() makes them, or none; always the same of the same ones.
FirstView firstView(std::span<const OutlineSample> samples, scene::WorldAxes axes);

}  // namespace isolux::volume
