// Which format a file has: told by content first, then by name.
#pragma once

#include <filesystem>

#include "volume/read/input/bytes.h"

namespace isolux::volume {

enum class FileFormat { unknown, nrrd, vtkLegacy, mesh, vti, tiff, dicom, nifti, mgh, metaImage };

// unknown: it has no header that is known.
FileFormat formatOf(const Bytes& bytes, const std::filesystem::path& path);

}  // namespace isolux::volume
