// White matter of a brain, told by the values deep in the body.
#pragma once

#include <optional>

#include "base/progress.h"
#include "scene/rules/automatic.h"

namespace isolux::volume {

class Grid;

// Finds the white matter in a T1 scan of a head or of a brain alone. It looks at every second voxel along
// each axis that lies at least a fifth of the greatest depth deep in the body above `skin` (body.h): the
// classes of Otsu's two thresholds (1979) are fluid, grey and white matter. Nothing where the brightest is
// not from a quarter to six tenths of them, or the mean of the middle one not from 0.72 to 0.92 of its: in
// other scans. Data units.
std::optional<scene::WhiteMatter> whiteMatterOf(const Grid& grid, double skin, base::Progress& progress);

}  // namespace isolux::volume
