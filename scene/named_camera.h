// Defines cameras by words: by the viewer's side, and turned by degrees (scene/camera.h has the arithmetic of
// the mouse).
#pragma once

#include <string_view>

#include <glm/vec3.hpp>

#include "scene/camera.h"

namespace isolux::scene {

// Returns the view of this name: "left" ... "inferior", or the end of an axis on the viewer's side, "+x" or
// "x", "-y", ..., in any case. Throws base::Error{usage}.
StandardView standardViewNamed(std::string_view name, WorldAxes axes);

// Turns the camera about the target by degrees. A positive azimuth, applied first, turns the eye about
// camera.up to its right (counterclockwise seen from above). A positive elevation, applied second, moves the
// eye up, over the top and down behind. Angles that are not finite change nothing.
Camera turned(const Camera& camera, double azimuthDegrees, double elevationDegrees);
// Turns eye and up by degrees about an axis through the target (any length but 0), counterclockwise seen from
// its tip.
Camera turnedAbout(const Camera& camera, glm::dvec3 axis, double degrees);

}  // namespace isolux::scene
