// DICOM series: a folder of files (with its subfolders), or the series a single file belongs to.
//
// Decoded by the vtk-dicom library (decode.h). Headers are read file by file with its parser; grouping,
// sorting by position and geometry are ours (slice_stack.h), because a regular grid must be proven, not
// assumed. Sizes are compared with each file before anything is decoded. vtk-dicom's messages are caught.
//
// Rescale: kept as slope and intercept when all slices of a time step agree, else applied, in float32, as are
// modality LUTs. Slices of another size, type, orientation, unit or patient than the majority of the series
// are left out with a warning. Objects that are no scans are refused by name (dicom_object.h). Throws
// base::Error{input}; Error{usage} for a series that is not there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <vtkSmartPointer.h>
#include <glm/vec3.hpp>

#include "base/progress.h"
#include "volume/read/dicom/dicom_series.h"
#include "volume/read/dicom/repeated_slices.h"
#include "volume/read/process/reader_messages.h"

class vtkDataArray;

namespace isolux::readers {

class VtkMessages;

// One image of a file, and where it lies.
struct DicomFrame {
  bool hasPosition = false;
  glm::dvec3 positionMm{0.0}, rowDirection{1, 0, 0}, columnDirection{0, 1, 0};
  double spacingXMm = 0.0, spacingYMm = 0.0;  // 0: not stated
  double distanceMm = 0.0;                    // of slices, along their normal; 0: not stated
  double thicknessMm = 0.0;                   // the distance, else of a slice; 0: not stated
  double slope = 1.0, intercept = 0.0;
  std::string unit;  // of values: "HU", "Gy", ...; "": not stated
  volume::ImageTags tags;
};

// Values that a table gives to stored ones, from `first` on; its ends hold for all beyond them.
struct ModalityLut {
  std::int64_t first = 0;
  std::vector<double> values;  // empty: none
};

inline constexpr const char* kNoSeries = "unknown";  // of files without a SeriesInstanceUID

struct DicomFile : volume::DicomStatements {
  std::filesystem::path path;
  std::string notAScan;  // why a DICOM object without slices is not read (dicom_object.h); "": it may be
  std::string transferSyntax, instanceUid, frameOfReference, photometric;
  int columns = 0, rows = 0, samples = 1, bitsAllocated = 0;  // columns, rows: of a slice
  int tilesAcross = 1, tilesDown = 1;  // more: one image holds the frames as tiles, row by row (frames.h)
  std::uint64_t pixelDataAt = 0;       // where the pixel data begin, bytes
  bool isSigned = false;
  bool isSegmentation = false;                   // read by itself (segmentation.h); notAScan says so, too
  bool isCine = false;                           // frames are moments
  double pixelAspect = 1.0;                      // height / width of a pixel whose size is not stated
  double windowCenter = 0.0, windowWidth = 0.0;  // after rescale; width 0: not stated
  ModalityLut lut;
  std::optional<std::pair<double, double>> padding;  // stored values of pixels outside the image, from and to
  int instance = 0;
  std::vector<DicomFrame> frames;
  std::vector<std::string> warnings;

  bool darkIsHigh() const { return photometric == "MONOCHROME1"; }
  // Pixels of the decoded file, and which of them is the first one of row `y` of a frame.
  std::size_t decodedPixels() const;
  std::size_t decodedRow(std::size_t frame, int y) const;
  // What a stored value of a frame means.
  double valueOf(const DicomFrame& frame, double stored) const;
};

// The header of one file; without frames: no image. Throws Error{input} for what is damaged or not supported.
DicomFile readHeader(const std::filesystem::path& file);
// Throws also for what vtk-dicom finds damaged.
DicomFile readWholeHeader(const std::filesystem::path& file);

// The voxels of a file; of what was decoded. Nothing: a type that is not supported.
std::optional<volume::VoxelType> voxelTypeOf(const DicomFile& file);
std::optional<volume::VoxelType> voxelTypeOf(vtkDataArray* array);

// Returns the pixels of all files, in their order, by vtk-dicom, which knows the transfer syntaxes (through
// GDCM). RGB of JPEG is what the file says that it is. `name`: of all of them, for messages. Throws
// base::Error: input for pixels that cannot be decoded, with the file; interrupted.
vtkSmartPointer<vtkDataArray> decodeFiles(const std::vector<DicomFile>& files, const std::string& name,
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
