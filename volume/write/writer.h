// Writes a Grid to a file, format by extension: .mhd (+ .raw beside it), .mha, .nrrd, .vti.
//
// Values, geometry (origin, spacing, directions) and stored type survive a round trip through readVolume();
// slope and intercept are applied on writing when the format has no field for them. The file is written
// beside its name and renamed when complete. That the axes are anatomical is stated where they are and the
// format has words for it: .mhd, .mha, .nrrd.
#pragma once

#include <filesystem>

#include "scene/world_axes.h"
#include "volume/grid.h"

namespace isolux::volume {

// Throws Error{usage} for an unknown extension and Error{input} when the file cannot be written.
void writeVolume(const Grid& grid, const std::filesystem::path& path,
                 scene::WorldAxes axes = scene::WorldAxes::zUp);

}  // namespace isolux::volume
