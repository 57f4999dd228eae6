// What the HDF5 library says of a dataset and of where its chunks lie; no voxel is read. Throws base::Error
// (input, memory, usage, interrupted).
#pragma once

#include <filesystem>

#include "base/progress.h"
#include "readers/serve.h"

namespace isolux::readers {

Hdf5Table describeDataset(const std::filesystem::path& path, const volume::ReadOptions& options,
                          base::Progress& progress);

}  // namespace isolux::readers
