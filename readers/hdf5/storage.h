// How datasets are stored: where the chunks of a plain one lie, and which other datasets a virtual one is
// made of. `name` is that of the file, for messages. Each throws base::Error (input, memory, interrupted).
#pragma once

#include <string>

#include "base/progress.h"
#include "readers/hdf5/hdf5_handles.h"
#include "readers/serve.h"

namespace isolux::readers {

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
