// VTK's XML files: images (.vti) and PolyData (.vtp), read by VTK after a check of what they claim. Its
// messages are caught. Throws base::Error (input, memory, usage, interrupted).
#pragma once

#include <filesystem>

#include "base/progress.h"
#include "volume/read/process/reader_messages.h"

namespace isolux::readers {

volume::DecodedVolume decodeVti(const std::filesystem::path& path, const volume::ReadOptions& options,
                                base::Progress& progress);

// All points are finite and all indices in range.
volume::TriangleMesh decodePolyData(const std::filesystem::path& path, base::Progress& progress);

}  // namespace isolux::readers
