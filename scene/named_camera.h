// Cameras that are said in words: by the side they stand on, and turned by degrees (scene/camera.h has the
// arithmetic of the mouse).
#pragma once

#include <string_view>

#include <glm/vec3.hpp>

#include "scene/camera.h"

namespace isolux::scene {

// The view of this name: "left" ... "inferior", or the end of an axis that the viewer stands on, "+x" or "x",
// "-y", ..., in any case. Throws base::Error{usage}.
StandardView standardViewNamed(std::string_view name, WorldAxes axes);

// Turned about the target by degrees: azimuth about camera.up, > 0: the eye moves to its right
// (counterclockwise as seen from above); then elevation, > 0: the eye moves up, over the top and down behind.
// Angles that are not finite change nothing.
Camera turned(const Camera& camera, double azimuthDegrees, double elevationDegrees);
// Eye and up turned by degrees about an axis (any length but 0) through the target, counterclockwise as seen
// from its tip.
Camera turnedAbout(const Camera& camera, glm::dvec3 axis, double degrees);

}  // namespace isolux::scene
