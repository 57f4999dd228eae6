// Reads what a scene::Source names: a file or the file of a time step, a level, a blend of two time steps,
// and a second volume combined with it.
#pragma once

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/prepared/csg.h"
#include "volume/read/volume_file.h"

namespace isolux::volume {

// The volume, and the second one's isovalue where there is one. `first`: openSource() of the source or of its
// (first) step. Throws base::Error.
CsgResult readSource(const scene::Source& source, const VolumeFile& first, base::Progress& progress);

}  // namespace isolux::volume
