// A driver of the HDF5 library that only reads, and can note where data of datasets lie instead of reading
// them.
//
// The library tells addresses of chunks (H5Dget_chunk_info) in time proportional to their number for each of
// them: 40 s for 32768 chunks with HDF5 1.10. H5Dread_chunk looks a chunk up in logarithmic time, and its one
// read shows the address.
#pragma once

#include <cstdint>

#include <hdf5.h>

namespace isolux::readers {

// Where the last read of data began; the file's own addresses, whatever stands before its signature.
struct RecordedRead {
  bool recording = false;  // data are noted, not read
  bool happened = false;
  std::uint64_t address = 0, size = 0;
};
RecordedRead& recordedRead();

// For H5Pset_driver().
hid_t recordingDriver();

}  // namespace isolux::readers
