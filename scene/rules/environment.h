// Determines the environment of a scene and its rotation, from several settings of light.environment.
//
// An environment map's file has priority, then a constant environment, then a built-in one. Setting one is
// therefore sufficient, and older scenes keep their sky colour.
#pragma once

#include <string>

#include <glm/vec4.hpp>

#include "scene/scene.h"
#include "scene/world_axes.h"

namespace isolux::scene {

enum class EnvironmentKind { file, oneColor, builtIn };

EnvironmentKind kindOf(const Environment& environment);
bool hasOneColor(const Environment& environment);
// Makes this built-in light the scene's environment, whatever it was before; its rotation stays.
void chooseBuiltIn(Environment& environment, BuiltInLight light);

// Returns the whole rotation, quaternion (w, x, y, z), from the environment's own axes
// (gi/sampling/environment.h) to the world's. Built-in lights are oriented by the volume's up and front,
// files by the world's axes. Then follow `rotation`, `elevation` about the axis to the right of a viewer of
// the front, and `azimuth` about up. Returns the quaternion unchanged if no other setting rotates the
// environment.
glm::dvec4 rotationOf(const Environment& environment, WorldAxes axes);
// Sets the quaternion such that rotationOf() equals this rotation; azimuth and elevation stay.
void setRotation(Environment& environment, const glm::dvec4& rotation, WorldAxes axes);

}  // namespace isolux::scene
