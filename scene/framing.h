// Computes cameras that frame a set of points, given only its extent along certain directions. All lengths in
// mm.
//
// A point is in the image if it is on the inner side of four planes through the eye (or, orthographic,
// parallel to the view). Therefore only the points farthest along the four normals matter, and for the target
// the nearest and farthest along the view.
#pragma once

#include <array>
#include <span>

#include <glm/vec3.hpp>

#include "scene/camera.h"

namespace isolux::scene {

// Returns the directions (world, of any length) along which to measure a set, for images of this aspect
// (width / height) seen in the camera's direction.
constexpr int framingDirectionCount = 6;
using FramingDirections = std::array<glm::dvec3, framingDirectionCount>;
FramingDirections framingDirections(const Camera& camera, double aspect);

// Returns the camera with the same direction and up, as near as the whole set is in the image with a margin
// of 4 % of its half size, centred. The target is at the middle of the set's depth. `farthest`: the largest
// dot product of each direction with a point of the set. Returns the camera unchanged if a number is not
// finite.
Camera framing(const Camera& camera, double aspect,
               const std::array<double, framingDirectionCount>& farthest);

// As above for points, framed within `room`: the largest extent across and up from the middle of the image,
// in halves of its height; {aspect, 1}: the whole image.
Camera framing(const Camera& camera, glm::dvec2 room, std::span<const glm::dvec3> pointsMm);

// Returns the camera with the same direction and up, aimed at the centre of a ball that fits the image with
// that margin, however the camera is turned about it.
Camera framingBall(const Camera& camera, double aspect, glm::dvec3 centreMm, double radiusMm);

// Returns a camera that fitted() has made of this box, moved back until the box fits `room`: the largest
// extent across and up from the middle of the image, in halves of its height. Returns any other camera
// unchanged: the user has chosen its view.
Camera fittedTo(const Camera& camera, glm::dvec3 boundsMinMm, glm::dvec3 boundsMaxMm, glm::dvec2 room);

}  // namespace isolux::scene
