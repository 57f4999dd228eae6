// DICOM series: a folder of files (with its subfolders), or the series a single file belongs to.
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
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "volume/read/dicom/dicom_series.h"
#include "volume/read/process/reader_messages.h"

class vtkDataArray;
class vtkDICOMReader;

namespace isolux::readers {

class VtkMessages;

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
  volume::Patient patient;
  std::string study, studyDescription, studyDate;
  std::string series, description, date, number, modality, kernel, transferSyntax;
  int columns = 0, rows = 0, samples = 1, bitsAllocated = 0;
  bool isSigned = false;
  bool darkIsHigh = false;                       // MONOCHROME1
  double windowCenter = 0.0, windowWidth = 0.0;  // after rescale; width 0: not stated
  int instance = 0;
  std::vector<DicomFrame> frames;
};

// The header of one file; without frames: no image. Throws Error{input} for what is damaged or not supported.
DicomFile readHeader(const std::filesystem::path& file);

// Headers of all DICOM files in `folder` and its subfolders, to that depth, folder by folder.
std::vector<DicomFile> scanDicomFolder(const std::filesystem::path& folder, int depth,
                                       base::Progress& progress, std::vector<std::string>& warnings);

// The voxels of a file; of what was decoded. Nothing: a type that is not supported.
std::optional<volume::VoxelType> voxelTypeOf(const DicomFile& file);
std::optional<volume::VoxelType> voxelTypeOf(vtkDataArray* array);

// Decodes all files, in their order.
void decodeFiles(vtkDICOMReader* reader, const std::vector<DicomFile>& files, const std::string& folder,
                 const VtkMessages& messages, base::Progress& progress);

// `path` is a folder or a file.
volume::DecodedVolume decodeDicom(const std::filesystem::path& path, const volume::ReadOptions& options,
                                  base::Progress& progress);

// What volume::indexDicom() promises; files of `skip` are passed by.
volume::DicomIndexEnd indexDicomFolder(const std::filesystem::path& folder,
                                       const std::vector<std::string>& skip,
                                       const std::function<void(const volume::DicomSeries&)>& found,
                                       base::Progress& progress);

// What volume::previewDicom() promises, of frame `options.timeStep`.
volume::DecodedImage previewDicomFile(const std::filesystem::path& file, const volume::ReadOptions& options,
                                      base::Progress& progress);

}  // namespace isolux::readers
