// Headers of DICOM files: what a file holds, compared with its size before anything is decoded.
#include <algorithm>
#include <cstdint>
#include <string_view>

#include <vtkDICOMItem.h>
#include <vtkDICOMMetaData.h>
#include <vtkDICOMParser.h>
#include <vtkDICOMTagPath.h>
#include <vtkDICOMValue.h>
#include <vtkNew.h>

#include "base/error.h"
#include "readers/dicom/dicom.h"
#include "readers/dicom/dicom_object.h"
#include "readers/dicom/elements.h"
#include "readers/dicom/frames.h"
#include "readers/dicom/segmentation.h"
#include "readers/vtk_messages.h"
#include "volume/read/input/bytes.h"

namespace isolux::readers {

using namespace volume;
namespace fs = std::filesystem;
using base::throwInput;

namespace {

constexpr int mostFrames = 65535;

int integer(vtkDICOMMetaData* meta, vtkDICOMTag tag, int otherwise) {
  const vtkDICOMValue& value = meta->Get(tag);
  return value.IsValid() && value.GetNumberOfValues() > 0 ? value.AsInt() : otherwise;
}

std::string text(vtkDICOMMetaData* meta, vtkDICOMTag tag) {
  return textIn(meta->Get(tag));
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

// What lists of series show, and small pictures need.
void describe(vtkDICOMMetaData* meta, DicomFile& file) {
  file.patient = {personName(meta, DC::PatientName), text(meta, DC::PatientID),
                  text(meta, DC::PatientBirthDate)};
  file.study = text(meta, DC::StudyInstanceUID);
  file.studyDescription = text(meta, DC::StudyDescription);
  file.studyDate = text(meta, DC::StudyDate);
  file.series = text(meta, DC::SeriesInstanceUID);
  if (file.series.empty()) file.series = kNoSeries;
  file.description = text(meta, DC::SeriesDescription);
  file.date = text(meta, DC::SeriesDate);
  if (file.date.empty()) file.date = text(meta, DC::AcquisitionDate);
  file.number = text(meta, DC::SeriesNumber);
  file.modality = text(meta, DC::Modality);
  file.kernel = text(meta, DC::ConvolutionKernel);
  file.instanceUid = text(meta, DC::SOPInstanceUID);
  file.frameOfReference = text(meta, DC::FrameOfReferenceUID);
  file.instance = integer(meta, DC::InstanceNumber, 0);
}

void describePixels(vtkDICOMMetaData* meta, DicomFile& file) {
  file.columns = integer(meta, DC::Columns, 0);
  file.rows = integer(meta, DC::Rows, 0);
  file.samples = integer(meta, DC::SamplesPerPixel, 1);
  file.bitsAllocated = integer(meta, DC::BitsAllocated, 0);
  file.isSigned = integer(meta, DC::PixelRepresentation, 0) == 1;
  file.photometric = text(meta, DC::PhotometricInterpretation);
  file.windowCenter = numberIn(meta->Get(DC::WindowCenter)).value_or(0.0);
  file.windowWidth = std::max(0.0, numberIn(meta->Get(DC::WindowWidth)).value_or(0.0));
  auto padding = numberIn(meta->Get(DC::PixelPaddingValue));
  if (!padding) padding = numberIn(meta->Get(DC::FloatPixelPaddingValue));
  if (padding)
    file.padding = std::minmax(*padding, numberIn(meta->Get(DC::PixelPaddingRangeLimit)).value_or(*padding));
  const int stored = integer(meta, DC::BitsStored, file.bitsAllocated);
  const int high = integer(meta, DC::HighBit, stored - 1);
  if (high != stored - 1)
    file.warnings.push_back("HighBit " + std::to_string(high) + " contradicts BitsStored " +
                            std::to_string(stored) + "; the lowest bits are read");
  if (text(meta, DC::LossyImageCompression) == "01")
    file.warnings.emplace_back("LossyImageCompression 01: the pixels have lost detail by compression");
  if (file.darkIsHigh())
    file.warnings.emplace_back(
        "PhotometricInterpretation MONOCHROME1: low values are bright; kept as stored");
  if (file.photometric == "PALETTE COLOR")
    file.warnings.emplace_back("PhotometricInterpretation PALETTE COLOR: values are numbers of colours");
}

// What is claimed must be there, and nothing else.
// `stated`: length of the pixel data, bytes.
void checkPixels(std::uint32_t stated, int bitsStored, int frames, DicomFile& file) {
  const std::string name = file.path.string();
  if (frames > mostFrames)
    throwInput(name, "NumberOfFrames",
               std::to_string(frames) + " frames are announced; at most 65535 are read");
  if (file.columns < 1 || file.rows < 1) throwInput(name, "Rows, Columns", "the image has no pixels");
  if (file.samples < 1 || file.samples > 4 || file.bitsAllocated < 1 || file.bitsAllocated > 64)
    throwInput(name, "BitsAllocated",
               "pixels of " + std::to_string(file.samples) + " x " + std::to_string(file.bitsAllocated) +
                   " bits are not supported");
  if (bitsStored > file.bitsAllocated)
    throwInput(name, "BitsStored",
               std::to_string(bitsStored) + " bits do not fit into the " +
                   std::to_string(file.bitsAllocated) + " of BitsAllocated");
  const std::uint64_t bits = static_cast<std::uint64_t>(file.columns) *
                             static_cast<std::uint64_t>(file.rows) * static_cast<std::uint64_t>(frames) *
                             static_cast<std::uint64_t>(file.samples) *
                             static_cast<std::uint64_t>(file.bitsAllocated);
  const bool halfColours = file.photometric.ends_with("_422") || file.photometric.ends_with("_420");
  const std::uint64_t bytes = (bits + 7) / 8, size = FileBytes(file.path).size();
  const bool plain = file.transferSyntax.empty() || file.transferSyntax == "1.2.840.10008.1.2" ||
                     file.transferSyntax == "1.2.840.10008.1.2.1" ||
                     file.transferSyntax == "1.2.840.10008.1.2.2";
  const std::uint64_t bestRatio = plain ? (halfColours ? 2 : 1) : bestRatioOf(file.transferSyntax);
  constexpr std::uint32_t unknownLength = 0xffffffff;
  const bool isExact = plain && !halfColours && stated != unknownLength;
  if (bytes / bestRatio > size || (isExact && stated < bytes))
    throwInput(name, "pixel data",
               "truncated: " + std::to_string(bytes) + " bytes are announced, the file has " +
                   std::to_string(isExact ? std::min<std::uint64_t>(stated, size) : size));
  if (isExact && stated > bytes + 1)
    file.warnings.push_back("the pixel data hold more than the header announces: " + std::to_string(stated) +
                            " bytes, not " + std::to_string(bytes));
}

// PS3.3 C.11.1.
void readModalityLut(vtkDICOMMetaData* meta, DicomFile& file) {
  if (!meta->Has(DC::ModalityLUTSequence)) return;
  const auto element = [&](vtkDICOMTag tag) -> const vtkDICOMValue& {
    return meta->Get(vtkDICOMTagPath(DC::ModalityLUTSequence, 0, tag));
  };
  const std::vector<double> descriptor = numbersIn(element(DC::LUTDescriptor), 3);
  const vtkDICOMValue& data = element(DC::LUTData);
  // Its numbers are of 16 bits, with or without a sign; 0 entries are 65536.
  const auto unsignedWord = [](double word) { return word <= 0.0 ? word + 65536.0 : word; };
  const std::size_t count = descriptor.empty() ? 0 : static_cast<std::size_t>(unsignedWord(descriptor[0]));
  const std::size_t bytes = data.IsValid() ? data.GetVL() : 0;
  if (count == 0 || bytes < count)
    throwInput(file.path.string(), "ModalityLUTSequence", "its table is missing or shorter than stated");
  const std::size_t each = bytes >= 2 * count ? 2 : 1;
  file.lut.first = static_cast<std::int64_t>(descriptor[1]);
  if (!file.isSigned && file.lut.first < 0) file.lut.first += 65536;
  if (file.isSigned && file.lut.first > 32767) file.lut.first -= 65536;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t word = data.GetUnsignedShort(each == 2 ? i : i / 2);
    file.lut.values.push_back(static_cast<double>(each == 2 ? word : (word >> (8 * (i % 2))) & 0xff));
  }
  const std::string type = textIn(element(DC::ModalityLUTType));
  for (DicomFrame& frame : file.frames) frame.unit = type == "HU" || type == "OD" ? type : "";
}

}  // namespace

std::size_t DicomFile::decodedPixels() const {
  const std::size_t images = tilesAcross > 1 || tilesDown > 1
                                 ? static_cast<std::size_t>(tilesAcross) * static_cast<std::size_t>(tilesDown)
                                 : frames.size();
  return images * static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
}

std::size_t DicomFile::decodedRow(std::size_t frame, int y) const {
  const auto across = static_cast<std::size_t>(tilesAcross);
  const std::size_t row = frame / across * static_cast<std::size_t>(rows) + static_cast<std::size_t>(y);
  return (row * across + frame % across) * static_cast<std::size_t>(columns);
}

double DicomFile::valueOf(const DicomFrame& frame, double stored) const {
  if (lut.values.empty()) return frame.slope * stored + frame.intercept;
  const double last = static_cast<double>(lut.values.size() - 1);
  return lut.values[static_cast<std::size_t>(std::clamp(stored - static_cast<double>(lut.first), 0.0, last))];
}

DicomFile readHeader(const fs::path& path) {
  DicomFile file;
  file.path = path;
  vtkNew<vtkDICOMMetaData> meta;
  meta->SetNumberOfInstances(1);
  vtkNew<vtkDICOMParser> parser;
  parser->SetMetaData(meta);
  parser->SetFileName(path.c_str());
  parser->Update();
  file.transferSyntax = text(meta, DC::TransferSyntaxUID);
  if (const std::string problem = transferSyntaxProblem(file.transferSyntax); !problem.empty())
    throwInput(path.string(), "TransferSyntaxUID", problem);
  describe(meta, file);
  std::string sopClass = text(meta, DC::SOPClassUID);
  if (sopClass.empty()) sopClass = text(meta, DC::MediaStorageSOPClassUID);
  const DicomObject object = dicomObject(sopClass, file.modality);
  file.notAScan = object.notAScan;
  file.isSegmentation = isSegmentationClass(sopClass);
  if (!parser->GetPixelDataFound()) return file;
  if (!file.notAScan.empty()) {
    file.frames.emplace_back();
    return file;
  }
  if (!object.remark.empty()) file.warnings.push_back(object.remark);
  describePixels(meta, file);
  const int frames = std::max(1, integer(meta, DC::NumberOfFrames, 1));
  checkPixels(parser->GetPixelDataVL(), integer(meta, DC::BitsStored, 0), frames, file);
  if (file.modality == "RTDOSE" && !meta->Has(DC::DoseGridScaling))
    throwInput(path.string(), "DoseGridScaling", "is missing: the doses have no scale");
  readFrames(meta, frames, file);
  if (!object.hasUnit)
    for (DicomFrame& frame : file.frames) frame.unit.clear();
  readModalityLut(meta, file);
  file.pixelDataAt = static_cast<std::uint64_t>(parser->GetFileOffset());
  const std::string imageType = text(meta, DC::ImageType);
  if (imageType.find("MOSAIC") != std::string::npos) splitSiemensMosaic(meta, file);
  if (imageType.find("VFRAME") != std::string::npos) splitUnitedMosaic(meta, file);
  return file;
}

DicomFile readWholeHeader(const fs::path& path) {
  const VtkMessages messages;
  DicomFile file = readHeader(path);
  if (!messages.errors().empty()) throwInput(path.string(), "header", messages.errors().front());
  return file;
}

}  // namespace isolux::readers
