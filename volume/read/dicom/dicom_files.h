// Which files are DICOM, by their first bytes; what is in them is for the reader (readers/dicom).
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace isolux::volume {

// Does `head` (the first 132 bytes or more) carry the DICOM mark?
bool looksLikeDicom(std::string_view head);

// True when `folder` or a direct subfolder has a DICOM file. Throws Error{input} for a folder that cannot be
// listed or has more than 100000 files.
bool hasDicomFiles(const std::filesystem::path& folder);

// All of them, sorted by path. Throws likewise.
std::vector<std::filesystem::path> dicomFilesIn(const std::filesystem::path& folder);

}  // namespace isolux::volume
