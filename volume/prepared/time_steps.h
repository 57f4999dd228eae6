// Blends of two time steps, and checks that files fit together as steps.
#pragma once

#include <string>

#include "base/progress.h"
#include "volume/volume.h"

namespace isolux::volume {

// (1 - fraction) first + fraction second, voxel by voxel, in data values and float32; missing where either
// is. What the file states of the values of one step (noise) is not known of the blend. Both have the same
// geometry. Throws Error{memory}, Error{interrupted}.
Volume blendedSteps(Volume first, const Volume& second, double fraction, base::Progress& progress);

// Throws Error{input} naming the first file whose voxels differ in number, spacing, position or type from
// those of step 0. `read` is the volume of `step`, at the level of `source`; of step 0, those files are
// compared that say so in a header.
void checkFits(const scene::Source& source, int step, const Volume& read, base::Progress& progress);

// "time step 7 does not exist; ...", where it does not. A fraction needs the next step, too.
void checkStep(const scene::Source& source, int steps);

}  // namespace isolux::volume
