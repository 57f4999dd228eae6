// The procedural head: what a CT of one would hold, in Hounsfield units.
//
// Lengths in mm, patient axes (LPS: +x patient left, +y posterior, +z superior), origin between the ear
// canals. Symmetric but for a small metal bead on the patient's left earlobe.
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "volume/grid.h"

namespace isolux::volume {

// A cube of size^3 voxels around the whole head.
GridGeometry headGeometry(int size);

// Voxels in HU, as a scanner with a point spread of about one voxel would show them; `noise` is the standard
// deviation of added noise. Throws Error{interrupted}.
std::vector<std::int16_t> headVoxels(const GridGeometry& geometry, double noise, std::uint64_t seed,
                                     base::Progress& progress);

}  // namespace isolux::volume
