// Rotations that a user turns (an arcball, and heading, elevation and roll), and views that turn. Pure
// functions, no widgets.
//
// Quaternions are (w, x, y, z) as in the Scene, from the environment's own axes to the world's; results have
// unit length. Angles in degrees. World: +z superior.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "scene/camera.h"

namespace isolux::app {

// Where the middle of a light probe looks (its own +y): heading about the vertical axis, counterclockwise as
// seen from above, then elevation above the horizon, and roll about that direction. Heading and roll are in
// (-180, 180], elevation in [-90, 90]; straight up and down have roll 0.
struct TurnAngles {
  double heading = 0.0, elevation = 0.0, roll = 0.0;
};
TurnAngles anglesOf(const glm::dvec4& rotation);
glm::dvec4 rotationOf(const TurnAngles& angles);

// Turned by a drag on a ball that fills the picture: the front of the ball follows the pointer. Positions are
// relative to the picture's centre, x right, y up, in parts of half its smaller side. Beyond the ball lies a
// hyperbolic sheet (Holroyd's arcball), so that no position is outside.
glm::dvec4 turnedByDrag(const glm::dvec4& rotation, const scene::CameraFrame& frame, glm::dvec2 from,
                        glm::dvec2 to);

glm::dvec3 rotated(const glm::dvec4& rotation, glm::dvec3 v);      // to the world
glm::dvec3 rotatedBack(const glm::dvec4& rotation, glm::dvec3 v);  // to the environment's axes

// Returns a camera between two, for views that turn instead of jumping: `part` from 0 (the first) to 1 (the
// second, exactly). In between the view turns about one axis at an even rate, the target moves on a straight
// line, the distance changes by equal factors. Projection and angle of view are the second's. Both resolved.
scene::Camera cameraBetween(const scene::Camera& from, const scene::Camera& to, double part);

// How far a turn has come after a part of its time: slow at both ends.
double easedPart(double partOfTime);

}  // namespace isolux::app
