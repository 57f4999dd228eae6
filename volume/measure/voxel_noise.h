// The noise of a voxel that measures reckon with.
#pragma once

#include "base/progress.h"
#include "scene/noise.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::volume {

// What the scene says of it (derivatives.noise), else what is measured; and how far apart slices are that
// were resampled. Throws Error{interrupted}.
scene::NoiseModel voxelNoise(const PreparedVolume& volume, const scene::Scene& scene,
                             base::Progress& progress);

}  // namespace isolux::volume
