// Zarr and HDF5 as volumes that are read chunk by chunk.
#pragma once

#include <memory>
#include <string>

#include "base/progress.h"
#include "volume/bricks/chunked_volume.h"

namespace isolux::volume {

// `path` and `series` as those of Source: a Zarr folder, or "file.h5" with or without ":/dataset". Null for
// anything else. An HDF5 file is described by a reader, a process of its own, before this returns. Throws
// base::Error (input, usage, memory, interrupted).
std::shared_ptr<const ChunkedVolume> openArrays(const std::string& path, const std::string& series,
                                                base::Progress& progress);

}  // namespace isolux::volume
