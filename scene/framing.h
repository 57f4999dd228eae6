// Computes cameras that frame a set of points, given only its extent along certain directions. All lengths in
// mm.
//
// A point is in the image if it is on the inner side of four planes through the eye (or, orthographic,
// parallel to the view). Therefore only the points farthest along the four normals matter, and for the target
// the nearest and farthest along the view.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/camera.h"

namespace isolux::scene {

// A rectangle of the image that the framed set may fill: relative to the middle of the image, in halves of
// its height, y up.
struct Room {
  glm::dvec2 low{-1.0}, high{1.0};
  bool operator==(const Room&) const = default;
};
// The free rectangles, at least one, the most central first; the framed set fills one of them.
using Rooms = std::vector<Room>;
Rooms wholePicture(double aspect);  // width / height

// Returns the directions (world, of any length) along which to measure a set, for images with these free
// rectangles seen in the camera's direction.
constexpr std::size_t framingDirectionCount = 6;  // of each room
std::vector<glm::dvec3> framingDirections(const Camera& camera, const Rooms& rooms);

// Returns the nearest camera with the same direction and up whose image shows the whole set in one of the
// free rectangles, centred. The margin is 4 % of the set's half size. The target is at the middle of the
// set's depth. It uses the first rectangle that shows the set within 2 % of the largest size. `farthest`: the
// largest dot product of each direction with a point of the set. Returns the camera unchanged if a number is
// not finite.
Camera framing(const Camera& camera, const Rooms& rooms, std::span<const double> farthest);
Camera framing(const Camera& camera, const Rooms& rooms, std::span<const glm::dvec3> pointsMm);  // of these

// Returns the camera with the same direction and up, aimed at the centre of a ball. The ball fits the part of
// a free rectangle around the image's middle with that margin, however the camera is turned about it.
Camera framingBall(const Camera& camera, const Rooms& rooms, glm::dvec3 centreMm, double radiusMm);

std::array<glm::dvec3, 8> cornersOf(glm::dvec3 boundsMinMm, glm::dvec3 boundsMaxMm);

// Returns a camera that fitted() has made of this box, moved back until the box is in the free rectangle. If
// the rectangle is not around the image's middle, or several are given, returns framing() of the box. Returns
// any other camera unchanged, because the user has chosen its view.
// Calls `rooms` for cameras that fitted() has made only.
Camera fittedTo(const Camera& camera, glm::dvec3 boundsMinMm, glm::dvec3 boundsMaxMm,
                const std::function<Rooms()>& rooms);

}  // namespace isolux::scene
