// Which files a volume is read from, told without reading it: what must not be written meanwhile.
//
// All files of a series of time steps, a header's data files, both files of a NIfTI pair, all DICOM and TIFF
// files of a folder and its direct subfolders, all files of a Zarr folder, for one DICOM file those beside it
// (its series may be among them). Any thread; no errors: what cannot be read has no files, and reading it
// will say why.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace isolux::volume {

// `path` as Source::path. Each file exists; the first is `path` itself unless it is a folder or
// names several files.
std::vector<std::filesystem::path> filesOfVolume(const std::string& path);

}  // namespace isolux::volume
