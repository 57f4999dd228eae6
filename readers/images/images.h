// What OpenImageIO reads: TIFF volumes and light probes. Throws base::Error (input, memory, usage,
// interrupted).
#pragma once

#include <filesystem>

#include "base/progress.h"
#include "volume/read/process/reader_messages.h"

namespace isolux::readers {

// `path` is a file or a folder.
volume::DecodedVolume decodeTiff(const std::filesystem::path& path, const volume::ReadOptions& options,
                                 base::Progress& progress);

// Integer samples and those marked sRGB are decoded from the sRGB curve; alpha is left out; turned upright as
// the file says.
volume::DecodedImage decodeImage(const std::filesystem::path& path, base::Progress& progress);

}  // namespace isolux::readers
