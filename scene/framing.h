// Cameras that frame something by how far it reaches: any set of points, of which nobody needs the points
// themselves. All lengths in mm.
//
// A point is in a picture when it lies on the inner side of four planes through the eye (or, orthographic,
// parallel to the view). So of a set of points only the farthest along the four normals counts, and the
// nearest and farthest along the view, for the target.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/camera.h"

namespace isolux::scene {

// A rectangle of the picture that what is framed may fill: from the picture's middle, in halves of its
// height, y up.
struct Room {
  glm::dvec2 low{-1.0}, high{1.0};
  bool operator==(const Room&) const = default;
};
// Those that are free; what is framed fills one of them. At least one, with the most central ones first.
using Rooms = std::vector<Room>;
Rooms wholePicture(double aspect);  // width by height

// Along which directions (world, of any length) a set has to be measured for pictures with these rooms, seen
// in the camera's direction.
constexpr std::size_t framingDirectionCount = 6;  // of each room
std::vector<glm::dvec3> framingDirections(const Camera& camera, const Rooms& rooms);

// Same direction and up, as near as the whole set lies in one of the rooms with a margin of 4 % of its half
// size, centred; the target is at the middle of its depth. Takes the first room that shows the set as large
// as any does, but for 2 %. farthest: the largest dot product of each direction with a point of the set.
// Numbers that are not finite: the camera as it is.
Camera framing(const Camera& camera, const Rooms& rooms, std::span<const double> farthest);
Camera framing(const Camera& camera, const Rooms& rooms, std::span<const glm::dvec3> pointsMm);  // of these

// Same direction and up, aimed at the centre of a ball that fits the picture with that margin, however the
// camera is turned about it: within the part of a room that lies about the picture's middle.
Camera framingBall(const Camera& camera, const Rooms& rooms, glm::dvec3 centreMm, double radiusMm);

std::array<glm::dvec3, 8> cornersOf(glm::dvec3 boundsMinMm, glm::dvec3 boundsMaxMm);

// A camera as fitted() makes it of this box, moved back until the box lies in the room; where that is not
// about the picture's middle, or there are several, framing() of the box. Any other camera as it is: the user
// has chosen it.
Camera fittedTo(const Camera& camera, glm::dvec3 boundsMinMm, glm::dvec3 boundsMaxMm, const Rooms& rooms);

}  // namespace isolux::scene
