// Cameras that frame something by how far it reaches: any set of points, of which nobody needs the points
// themselves. All lengths in mm.
//
// A point is in a picture when it lies on the inner side of four planes through the eye (or, orthographic,
// parallel to the view). So of a set of points only the farthest along the four normals counts, and the
// nearest and farthest along the view, for the target.
#pragma once

#include <array>
#include <span>

#include <glm/vec3.hpp>

#include "scene/camera.h"

namespace isolux::scene {

// Along which directions (world, of any length) a set has to be measured for pictures of this aspect, width
// by height, seen in the camera's direction.
constexpr int framingDirectionCount = 6;
using FramingDirections = std::array<glm::dvec3, framingDirectionCount>;
FramingDirections framingDirections(const Camera& camera, double aspect);

// Same direction and up, as near as the whole set lies in the picture with a margin of 4 % of its half size,
// centred; the target is at the middle of its depth. farthest: the largest dot product of each direction with
// a point of the set. Numbers that are not finite: the camera as it is.
Camera framing(const Camera& camera, double aspect,
               const std::array<double, framingDirectionCount>& farthest);

// The same of points, which lie within `room`: how far they may reach across and up from the middle of the
// picture, in halves of its height; {aspect, 1}: all of it.
Camera framing(const Camera& camera, glm::dvec2 room, std::span<const glm::dvec3> pointsMm);

// Same direction and up, aimed at the centre of a ball that fits the picture with that margin, however the
// camera is turned about it.
Camera framingBall(const Camera& camera, double aspect, glm::dvec3 centreMm, double radiusMm);

// A camera as fitted() makes it of this box, moved back until the box lies within `room`: how far it may
// reach across and up from the middle of the picture, in halves of its height. Any other camera as it is:
// somebody has chosen what it shows.
Camera fittedTo(const Camera& camera, glm::dvec3 boundsMinMm, glm::dvec3 boundsMaxMm, glm::dvec2 room);

}  // namespace isolux::scene
