// Describes a dataset as the HDF5 library reads it: type, places of chunks, or which other datasets a virtual
// one is made of; no voxel is read. `name` is that of the file, for messages. Each throws base::Error (input,
// memory, usage, interrupted).
#pragma once

#include <filesystem>
#include <string>

#include "base/progress.h"
#include "readers/hdf5/hdf5_handles.h"
#include "readers/serve.h"

namespace isolux::readers {

Hdf5Table describeDataset(const std::filesystem::path& path, const volume::ReadOptions& options,
                          base::Progress& progress);

// By the driver that notes where chunks lie.
Hdf5Handle openedFile(const std::string& name);

// Chunk, filters and fill value of a dataset that has table.layout.dims, and its chunks behind those of the
// table.
void readStored(hid_t dataset, const std::string& name, Hdf5Table& table, base::Progress& progress);

// The fill value by a dataset's creation properties.
void readFill(hid_t properties, volume::Hdf5Layout& layout);

// The same of a virtual dataset of `file` with these creation properties: its sources must be alike and cut
// where their chunks are, in this file or in files of its folder.
void addVirtual(hid_t file, hid_t properties, const std::string& name, Hdf5Table& table,
                base::Progress& progress);

}  // namespace isolux::readers
