// Volumes whose voxels are plain bytes of a file: raw, and NRRD, MetaImage, NIfTI and .vti (appended, raw)
// without compression. Headers are read by the readers of whole files (volume/read).
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "volume/bricks/chunked_volume.h"
#include "volume/read/input/image_header.h"
#include "volume/read/input/read_options.h"

namespace isolux::volume {

// The header of a raw, NRRD, MetaImage, NIfTI or plain .vti file, however its voxels are written; nullopt of
// other formats. Throws as openPlainFile().
std::optional<ImageHeader> headerOfPlainFile(const std::filesystem::path& path, const ReadOptions& options);

// Null, with one line why, where its voxels cannot be read in parts: packed, written as text, of a type that
// is stored as another one. Throws base::Error{input} where the file is damaged as its reader would.
std::shared_ptr<const ChunkedVolume> openPlainFile(const std::filesystem::path& path,
                                                   const ReadOptions& options, std::string& reason);

}  // namespace isolux::volume
