// Opens datasets of HDF5 files (and of formats made of them: netCDF-4, NeXus, MATLAB 7.3, ilastik's).
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "base/progress.h"
#include "volume/read/chunks/array_volume.h"
#include "volume/read/input/bytes.h"

namespace isolux::volume {

// "file.h5:/group/dataset" taken apart; an empty dataset is the largest.
struct Hdf5Path {
  std::filesystem::path file;
  std::string dataset;
};
// Nothing unless `path` is an HDF5 file, or has ":/" behind the name of a file that exists.
std::optional<Hdf5Path> hdf5PathOf(const std::string& path);

// By the signature, which may stand behind other data.
bool looksLikeHdf5(const Bytes& bytes);

// Starts the reader. `series` names a dataset where the path does not; choices are "/DATASET<TAB>what it is".
// Throws base::Error (input, memory, interrupted).
std::unique_ptr<ArrayVolume> openHdf5(const Hdf5Path& path, const std::string& series,
                                      base::Progress& progress);

}  // namespace isolux::volume
