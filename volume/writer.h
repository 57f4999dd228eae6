// Writes a Grid to a file, format by extension: .mhd (+ .raw beside it), .mha, .nrrd, .vti.
//
// Values, geometry (origin, spacing, directions) and stored type survive a round trip through readVolume();
// slope and intercept are applied on writing when the format has no field for them. The file is written
// beside its name and renamed when complete.
#pragma once

#include <filesystem>

#include "volume/grid.h"

namespace isolux::volume {

// Throws Error{usage} for an unknown extension and Error{input} when the file cannot be written.
void writeVolume(const Grid& grid, const std::filesystem::path& path);

}  // namespace isolux::volume
