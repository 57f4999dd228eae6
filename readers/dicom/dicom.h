// DICOM series: a folder of files (also one level of subfolders), or the series a single file belongs to.
//
// Decoded by the vtk-dicom library, which knows the transfer syntaxes (through GDCM). Headers are read file
// by file with its parser; grouping, sorting by position and geometry are ours (slice_stack.h), because a
// regular grid must be proven, not assumed. Sizes are compared with each file before anything is decoded.
// vtk-dicom's messages are caught.
//
// Rescale: kept as slope and intercept when all slices agree, else applied, in float32. Unit HU when the
// modality is CT. Slices of another size, type or orientation than the majority of the series are left out
// with a warning. Throws base::Error{input}; Error{usage} for a series that is not there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "volume/read/process/reader_messages.h"

namespace isolux::readers {

// One image of a file, and where it lies.
struct DicomFrame {
  bool hasPosition = false;
  glm::dvec3 positionMm{0.0}, rowDirection{1, 0, 0}, columnDirection{0, 1, 0};
  double spacingXMm = 0.0, spacingYMm = 0.0;  // 0: not stated
  double thicknessMm = 0.0;
  double slope = 1.0, intercept = 0.0;
};

struct DicomFile {
  std::filesystem::path path;
  std::string series, description, modality, transferSyntax;
  int columns = 0, rows = 0, samples = 1, bitsAllocated = 0;
  bool isSigned = false;
  int instance = 0;
  std::vector<DicomFrame> frames;
};

// Headers of all DICOM files in `folder` and its direct subfolders, sorted by path.
std::vector<DicomFile> scanDicomFolder(const std::filesystem::path& folder, base::Progress& progress,
                                       std::vector<std::string>& warnings);

// `path` is a folder or a file.
volume::DecodedVolume decodeDicom(const std::filesystem::path& path, const volume::ReadOptions& options,
                                  base::Progress& progress);

}  // namespace isolux::readers
