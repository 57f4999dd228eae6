// Points that lie at (nearly) the same place, as meshes whose triangles share no points have them.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.h"

namespace isolux::volume {

// For each point the first one that it lies within `tolerance` of and that stands for itself, or its own
// number. Points are taken in their order, so the result depends on nothing else. At most 2^31 - 1 points,
// finite; tolerance > 0. Time proportional to the points. Throws Error{interrupted}.
std::vector<int> mergedPoints(std::span<const glm::dvec3> points, double tolerance,
                              const base::Progress& progress);

}  // namespace isolux::volume
