// Finds slices that were interpolated between others before the volume was written.
//
// An interpolated slice is smoother than the slices around it. The second differences across the slices
// therefore repeat with the distance of the original slices (Gallagher 2005, "Detection of linear and cubic
// interpolation in JPEG compressed images").
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "volume/grid.h"

namespace isolux::volume {

// Returns the power of `values` at a frequency, in parts of what values that do not depend on their positions
// have on average.
double powerAt(std::span<const double> values, std::span<const double> positions, double frequency);

// Returns for each axis the distance of the original slices, 2 to 5 voxels; 0 if none were interpolated.
// Throws Error{interrupted}. On all cores.
glm::dvec3 interpolatedSlices(const Grid& grid, base::Progress& progress);

}  // namespace isolux::volume
