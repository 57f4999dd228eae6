// Numbers for voxels that are missing, so that filters that reach over many voxels can pass.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.h"

namespace isolux::volume {

// How far from data (in the largest of the three distances, voxels) a missing voxel still gets a mean. Behind
// that stands 0, and a spline that interpolates the values hardly notices: its coefficients are sums of
// samples with weights that fall by 2 - sqrt(3) = 0.268 per voxel. With 1D weights sqrt(3) 0.268^|k| (of sum
// 3), what lies beyond d voxels on one of three axes weighs at most 3^3 2 sqrt(3) 0.268^d / (1 - 0.268) in
// all: 9e-8 for d = 16, less than the rounding of a float.
inline constexpr int kFilledRings = 16;

// Replaces NaN in `values` (x fastest). Voxels with a known one among their 26 neighbours get the mean of
// those; then, ring by ring, their neighbours the mean of what is known by now, kFilledRings times; all
// others 0. Each voxel is visited once, so the time is proportional to the voxels whatever the gaps are; on
// all cores, and the same numbers on any. Throws Error{interrupted}.
void fillMissing(std::vector<float>& values, glm::ivec3 dims, base::Progress& progress,
                 base::ProgressRange share);

}  // namespace isolux::volume
