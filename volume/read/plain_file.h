// Volumes that a header parsed here describes: raw, NRRD, MetaImage, NIfTI, MGH, .vtk and .vti; and those of
// them whose voxels are plain bytes of a file, read in parts.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "volume/bricks/chunked_volume.h"
#include "volume/read/file_format.h"
#include "volume/read/input/bytes.h"
#include "volume/read/input/image_header.h"
#include "volume/read/input/read_options.h"

namespace isolux::volume {

struct DescribedFile {
  ImageHeader header;
  std::unique_ptr<const Bytes> data;  // holds the voxels unless the header names files beside it
  OpenBeside beside;
  std::string whyWhole;  // as VolumeFile::whyWhole, unless the payload says it
};
inline constexpr const char* kOnlyThese = "only raw, NRRD, MetaImage, NIfTI, MGH and .vti files are";

// Opens the file and parses its header, however its voxels are written; null for other formats. `format` is
// set unless the options describe raw voxels. Throws base::Error{input}.
std::shared_ptr<const DescribedFile> describedFile(const std::filesystem::path& path,
                                                   const ReadOptions& options, FileFormat& format);

// Null, with one line why, where its voxels cannot be read in parts: packed, written as text, of a type that
// is stored as another one. Throws base::Error{input} where the files are shorter than the header says.
std::shared_ptr<const ChunkedVolume> plainVolume(const std::shared_ptr<const DescribedFile>& file,
                                                 std::string name, std::string& whyWhole);

}  // namespace isolux::volume
