// Which environment a scene has, and how it is turned: what follows from several settings of
// light.environment.
//
// A light probe's file comes first, then a sky of one colour, then a built-in light: so naming one is enough,
// and scenes of before, which say what colour their sky has, keep it.
#pragma once

#include <string>

#include <glm/vec4.hpp>

#include "scene/scene.h"
#include "scene/world_axes.h"

namespace isolux::scene {

enum class EnvironmentKind { file, oneColor, builtIn };

EnvironmentKind kindOf(const Environment& environment);
bool hasOneColor(const Environment& environment);
// Makes this one the scene's environment, however it was lit before; how it is turned stays.
void chooseBuiltIn(Environment& environment, BuiltInLight light);

// The whole rotation, quaternion (w, x, y, z), from the environment's own axes (gi/sampling/environment.h) to
// the world's: built-in lights stand by what is up and in front in the volume, files by the world's axes;
// then come `rotation`, `elevation` about the axis to the right of who looks at the front, and `azimuth`
// about up. The quaternion alone, as it is, where nothing else turns.
glm::dvec4 rotationOf(const Environment& environment, WorldAxes axes);
// Sets the quaternion so that rotationOf() is this rotation; azimuth and elevation stay.
void setRotation(Environment& environment, const glm::dvec4& rotation, WorldAxes axes);

}  // namespace isolux::scene
