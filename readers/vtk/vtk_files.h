// VTK's XML files: images (.vti) and PolyData (.vtp), read by VTK after a check of what they claim. Its
// messages are caught. Throws scene::Error (input, memory, usage, interrupted).
#pragma once

#include <filesystem>

#include "scene/progress.h"
#include "volume/read/reader_messages.h"

namespace isolux::readers {

volume::DecodedVolume decodeVti(const std::filesystem::path& path, const volume::ReadOptions& options,
                                scene::Progress& progress);

// All points are finite and all indices in range.
volume::TriangleMesh decodePolyData(const std::filesystem::path& path, scene::Progress& progress);

}  // namespace isolux::readers
