// Reads what a scene::Source names: a file or the file of a time step, a level, a blend of two time steps,
// and a second volume combined with it.
#pragma once

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/prepared/csg.h"

namespace isolux::volume {

// The volume, and the second one's isovalue where there is one. Throws base::Error.
CsgResult readSource(const scene::Source& source, base::Progress& progress);

}  // namespace isolux::volume
