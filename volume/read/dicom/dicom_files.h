// Which files are DICOM, by their first bytes; what is in them is for the reader (readers/dicom).
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

namespace isolux::volume {

// Does `head` (the first kDicomHeadBytes of a file) carry the DICOM mark, or begin with elements as old files
// do?
inline constexpr std::size_t kDicomHeadBytes = 4096;
bool looksLikeDicom(std::string_view head);

// The index of a disc (DICOMDIR), which has no pixels: its folder is opened instead.
bool isDicomIndex(const std::filesystem::path& file);

// How deep subfolders of a folder that is opened are looked at; discs have four or five.
inline constexpr int kDeepestDicomFolder = 8;

// By its first bytes; false for the index of a disc.
bool isDicomFile(const std::filesystem::path& file);

// True when `folder` or a subfolder has a DICOM file. Links to folders are not followed. Throws Error{input}
// for a folder that cannot be listed or has more than 100000 files.
bool hasDicomFiles(const std::filesystem::path& folder);

// All files, and all DICOM files, to this depth of subfolders, folder by folder. Throws likewise.
std::vector<std::filesystem::path> filesBelow(const std::filesystem::path& folder, int depth);
std::vector<std::filesystem::path> dicomFilesIn(const std::filesystem::path& folder, int depth);

}  // namespace isolux::volume
