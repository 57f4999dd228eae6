// Points of a mesh at (nearly) the same place, found in time proportional to their number.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/progress.h"

namespace isolux::volume {

// For each point the one it becomes: the first one of the list that is kept and not farther than `tolerance`
// (at least 0; in the points' unit), or itself, which is kept then. Points must be finite. Throws
// Error{interrupted}.
std::vector<int> mergedPoints(const std::vector<glm::dvec3>& points, double tolerance,
                              const scene::Progress& progress);

}  // namespace isolux::volume
