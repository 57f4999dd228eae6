// Cameras between two, for views that turn instead of jumping.
#pragma once

#include "scene/camera.h"

namespace isolux::app {

// `part` from 0 (the first) to 1 (the second, exactly). In between the view turns about one axis at an even
// rate, the target moves on a straight line, the distance changes by equal factors. Projection and angle of
// view are the second's. Both resolved.
scene::Camera cameraBetween(const scene::Camera& from, const scene::Camera& to, double part);

// How far a turn has come after a part of its time: slow at both ends.
double easedPart(double partOfTime);

}  // namespace isolux::app
