// Headers of DICOM files: what a slice is and where it lies.
#include <algorithm>
#include <cmath>
#include <string_view>

#include <vtkDICOMMetaData.h>
#include <vtkDICOMParser.h>
#include <vtkDICOMValue.h>
#include <vtkNew.h>

#include "base/error.h"
#include "readers/dicom/dicom.h"
#include "readers/limits.h"
#include "readers/serve.h"
#include "readers/vtk_messages.h"
#include "volume/read/dicom/dicom_files.h"
#include "volume/read/input/bytes.h"
#include "volume/read/input/text.h"

namespace isolux::readers {

using namespace volume;
namespace fs = std::filesystem;
using base::throwInput;

namespace {

constexpr int mostFrames = 65535;

bool numbers(const vtkDICOMValue& value, std::size_t count, double* out) {
  if (!value.IsValid() || value.GetNumberOfValues() < count) return false;
  for (std::size_t i = 0; i < count; ++i) {
    out[i] = value.GetDouble(i);
    if (!std::isfinite(out[i])) return false;
  }
  return true;
}

std::string text(vtkDICOMMetaData* meta, vtkDICOMTag tag) {
  const vtkDICOMValue& value = meta->Get(tag);
  return value.IsValid() ? std::string(trimmed(value.AsUTF8String())) : std::string();
}

int integer(vtkDICOMMetaData* meta, vtkDICOMTag tag, int otherwise) {
  const vtkDICOMValue& value = meta->Get(tag);
  return value.IsValid() && value.GetNumberOfValues() > 0 ? value.AsInt() : otherwise;
}

DicomFrame frameOf(vtkDICOMMetaData* meta, int index) {
  DicomFrame frame;
  double v[6];
  const auto get = [&](vtkDICOMTag tag, std::size_t count) {
    return numbers(meta->Get(0, index, tag), count, v);
  };
  if (get(DC::ImagePositionPatient, 3)) {
    frame.positionMm = {v[0], v[1], v[2]};
    if (get(DC::ImageOrientationPatient, 6)) {
      frame.rowDirection = {v[0], v[1], v[2]};
      frame.columnDirection = {v[3], v[4], v[5]};
      frame.hasPosition = true;
    }
  }
  if (get(DC::PixelSpacing, 2) || get(DC::ImagerPixelSpacing, 2)) {
    frame.spacingYMm = v[0];  // between rows, so along y
    frame.spacingXMm = v[1];
  }
  if (get(DC::SpacingBetweenSlices, 1) || get(DC::SliceThickness, 1)) frame.thicknessMm = std::abs(v[0]);
  if (get(DC::RescaleSlope, 1)) frame.slope = v[0];
  if (get(DC::RescaleIntercept, 1)) frame.intercept = v[0];
  if (frame.slope == 0.0) frame.slope = 1.0;
  return frame;
}

// How much smaller a compression makes pixels at best. JPEG writes two bits for 64 pixels at least.
std::uint64_t bestRatioOf(const std::string& transferSyntax) {
  constexpr std::string_view jpeg = "1.2.840.10008.1.2.4.5", losslessJpeg = "1.2.840.10008.1.2.4.70";
  if (transferSyntax == "1.2.840.10008.1.2.5") return 128;  // run lengths
  if (transferSyntax.starts_with(jpeg) || transferSyntax == losslessJpeg) return 1000;
  return 100000;
}

// The first of several ways of writing a name, and of several values.
std::string personName(vtkDICOMMetaData* meta, vtkDICOMTag tag) {
  const std::string whole = text(meta, tag);
  return whole.substr(0, whole.find_first_of("=\\"));
}

double number(vtkDICOMMetaData* meta, vtkDICOMTag tag) {
  double value = 0.0;
  return numbers(meta->Get(tag), 1, &value) ? value : 0.0;
}

// What lists of series show, and small pictures need.
void describe(vtkDICOMMetaData* meta, DicomFile& file) {
  file.patient = {personName(meta, DC::PatientName), text(meta, DC::PatientID),
                  text(meta, DC::PatientBirthDate)};
  file.study = text(meta, DC::StudyInstanceUID);
  file.studyDescription = text(meta, DC::StudyDescription);
  file.studyDate = text(meta, DC::StudyDate);
  file.description = text(meta, DC::SeriesDescription);
  file.date = text(meta, DC::SeriesDate);
  if (file.date.empty()) file.date = text(meta, DC::AcquisitionDate);
  file.number = text(meta, DC::SeriesNumber);
  file.kernel = text(meta, DC::ConvolutionKernel);
  file.darkIsHigh = text(meta, DC::PhotometricInterpretation) == "MONOCHROME1";
  file.windowCenter = number(meta, DC::WindowCenter);
  file.windowWidth = std::max(0.0, number(meta, DC::WindowWidth));
}

}  // namespace

DicomFile readHeader(const fs::path& path) {
  DicomFile file;
  file.path = path;
  vtkNew<vtkDICOMMetaData> meta;
  meta->SetNumberOfInstances(1);
  vtkNew<vtkDICOMParser> parser;
  parser->SetMetaData(meta);
  parser->SetFileName(path.c_str());
  parser->Update();
  if (!parser->GetPixelDataFound()) return file;
  file.series = text(meta, DC::SeriesInstanceUID);
  if (file.series.empty()) file.series = "unknown";
  describe(meta, file);
  file.modality = text(meta, DC::Modality);
  file.transferSyntax = text(meta, DC::TransferSyntaxUID);
  file.columns = integer(meta, DC::Columns, 0);
  file.rows = integer(meta, DC::Rows, 0);
  file.samples = integer(meta, DC::SamplesPerPixel, 1);
  file.bitsAllocated = integer(meta, DC::BitsAllocated, 0);
  file.isSigned = integer(meta, DC::PixelRepresentation, 0) == 1;
  file.instance = integer(meta, DC::InstanceNumber, 0);
  const int frames = std::max(1, integer(meta, DC::NumberOfFrames, 1));
  if (frames > mostFrames)
    throwInput(path.string(), "NumberOfFrames",
               std::to_string(frames) + " frames are announced; at most 65535 are read");

  // What is claimed must be there, before anything is decoded.
  if (file.columns < 1 || file.rows < 1)
    throwInput(path.string(), "Rows, Columns", "the image has no pixels");
  if (file.samples < 1 || file.samples > 4 || file.bitsAllocated < 1 || file.bitsAllocated > 64)
    throwInput(path.string(), "BitsAllocated",
               "pixels of " + std::to_string(file.samples) + " x " + std::to_string(file.bitsAllocated) +
                   " bits are not supported");
  const std::uint64_t bits = static_cast<std::uint64_t>(file.columns) *
                             static_cast<std::uint64_t>(file.rows) * static_cast<std::uint64_t>(frames) *
                             static_cast<std::uint64_t>(file.samples) *
                             static_cast<std::uint64_t>(file.bitsAllocated);
  const std::uint64_t size = FileBytes(path).size();
  const bool plain = file.transferSyntax.empty() || file.transferSyntax == "1.2.840.10008.1.2" ||
                     file.transferSyntax == "1.2.840.10008.1.2.1" ||
                     file.transferSyntax == "1.2.840.10008.1.2.2";
  const std::uint64_t bestRatio = plain ? 1 : bestRatioOf(file.transferSyntax);
  if (bits / 8 / bestRatio > size)
    throwInput(path.string(), "pixel data",
               "truncated: " + std::to_string(bits / 8) + " bytes are announced, the file has " +
                   std::to_string(size));
  for (int frame = 0; frame < frames; ++frame) file.frames.push_back(frameOf(meta, frame));
  return file;
}

std::vector<DicomFile> scanDicomFolder(const fs::path& folder, int depth, base::Progress& progress,
                                       std::vector<std::string>& warnings) {
  std::vector<DicomFile> files;
  int broken = 0;
  std::string firstReason;
  const std::vector<fs::path> paths = dicomFilesIn(folder, depth);
  std::uint64_t bytes = 0;
  for (const fs::path& path : paths) bytes += FileBytes(path).size();
  allowHeaders(paths.size(), bytes);
  for (const fs::path& path : paths) {
    progress.throwIfStopped();
    nowReading(path);
    const VtkMessages messages;
    try {
      DicomFile file = readHeader(path);
      if (!messages.errors().empty()) throwInput(path.string(), "header", messages.errors().front());
      if (!file.frames.empty()) files.push_back(std::move(file));
    } catch (const base::Error& error) {
      if (error.kind() != base::ErrorKind::input) throw;
      if (broken++ == 0) firstReason = error.what();
    }
  }
  if (files.empty() && broken > 0) throwInput(folder.string(), "", "no usable DICOM image; " + firstReason);
  if (files.empty()) throwInput(folder.string(), "", "has no DICOM images");
  if (broken > 0)
    warnings.push_back(std::to_string(broken) +
                       " DICOM files are unreadable and left out; the first: " + firstReason);
  return files;
}

}  // namespace isolux::readers
