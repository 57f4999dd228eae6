// What the conventions of formats that are HDF5 files say of a dataset: netCDF-4 (CF), MINC 2, VTKHDF, NeXus,
// Imaris, ilastik.
#pragma once

#include <string>
#include <vector>

#include <hdf5.h>

#include "readers/hdf5/candidates.h"
#include "volume/read/chunks/array_statements.h"

namespace isolux::readers {

// The dataset that the file itself puts first: NeXus's `default` and `signal`, VTKHDF's `Scalars`; "": none.
std::string preferredOf(hid_t file);

// Of the dataset. `chosen.number` loses its sign where the file says so. Throws base::Error{input}: a VTKHDF
// file that holds no image, or contradicts itself.
volume::ArrayStatements statementsOf(hid_t file, Candidate& chosen, const std::string& name);

// An Imaris file keeps each time point and channel in a dataset of its own, which zeros fill up to whole
// chunks.
struct ImarisImage {
  std::vector<std::string> datasets;  // of all channels of the first time point, then those of the next
  std::uint64_t times = 1, channels = 1;
  std::vector<std::uint64_t> dims;  // z, y, x, without what is filled up
};
// With the chosen dataset alone where `alone`. No datasets where it is not Imaris's.
ImarisImage imarisImage(hid_t file, const Candidate& chosen, bool alone);

}  // namespace isolux::readers
