#include "readers/dicom/segmentation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include <vtkDICOMItem.h>
#include <vtkDICOMMetaData.h>
#include <vtkDICOMParser.h>
#include <vtkDICOMTagPath.h>
#include <vtkDICOMValue.h>
#include <vtkDataArray.h>
#include <vtkNew.h>

#include "base/error.h"
#include "base/number_text.h"
#include "readers/dicom/dicom.h"
#include "readers/dicom/elements.h"
#include "readers/limits.h"
#include "readers/vtk_messages.h"
#include "volume/labels/label_table.h"
#include "volume/read/input/bytes.h"
#include "volume/read/input/payload.h"
#include "volume/read/input/spacing_reliability.h"
#include "volume/read/input/text.h"

namespace isolux::readers {

using namespace volume;
namespace fs = std::filesystem;
using base::throwInput;

namespace {

enum class SegmentationKind { binary, fractional, labelMap };

struct SegmentFrame {
  glm::dvec3 positionMm{0.0};
  int segment = 0;  // its number; 0 in label maps, whose pixels name segments
  int slice = 0;
};

struct Segmentation {
  fs::path path;
  SegmentationKind kind = SegmentationKind::binary;
  std::string transferSyntax;
  int columns = 0, rows = 0, bits = 0;  // of a pixel
  double most = 1.0;                    // MaximumFractionalValue
  std::vector<Label> segments;          // in the order of the file
  std::vector<SegmentFrame> frames;
  glm::dvec3 row{1, 0, 0}, column{0, 1, 0};
  double spacingXMm = 0.0, spacingYMm = 0.0, distanceMm = 0.0;  // 0: not stated
  std::uint64_t pixelsAt = 0, pixelBytes = 0;                   // in the file, if not compressed
  bool compressed = false;

  std::string name() const { return path.string(); }
  std::size_t framePixels() const {
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }
};

std::string segmentText(vtkDICOMMetaData* meta, vtkDICOMTag tag) {
  return textIn(meta->Get(tag));
}

int segmentInteger(vtkDICOMMetaData* meta, vtkDICOMTag tag) {
  return static_cast<int>(std::clamp(numberIn(meta->Get(tag)).value_or(0.0), -2e9, 2e9));
}

// PS3.3 C.10.7.1.1: L* from 0 to 100, a* and b* from -128 to 127, each on 16 bits; white point D50. To linear
// sRGB by Bradford's adaptation to D65 (Lindbloom, "RGB/XYZ Matrices").
std::optional<glm::vec3> colorOfLab(const vtkDICOMValue& value) {
  const std::vector<double> lab = numbersIn(value, 3);
  if (lab.empty()) return std::nullopt;
  const double lightness = lab[0] / 655.35, a = lab[1] / 257.0 - 128.0, b = lab[2] / 257.0 - 128.0;
  const auto inverse = [](double t) {
    constexpr double delta = 6.0 / 29.0;
    return t > delta ? t * t * t : 3.0 * delta * delta * (t - 4.0 / 29.0);
  };
  const double fy = (lightness + 16.0) / 116.0;
  const glm::dvec3 xyz(0.96422 * inverse(fy + a / 500.0), inverse(fy), 0.82521 * inverse(fy - b / 200.0));
  const glm::dmat3 linearFromXyz(3.1338561, -0.9787684, 0.0719453, -1.6168667, 1.9161415, -0.2289914,
                                 -0.4906146, 0.0334540, 1.4052427);
  return glm::vec3(glm::clamp(linearFromXyz * xyz, 0.0, 1.0));
}

void readSegments(vtkDICOMMetaData* meta, Segmentation& file) {
  const vtkDICOMValue& segments = meta->Get(DC::SegmentSequence);
  const std::size_t count = segments.IsValid() ? segments.GetNumberOfValues() : 0;
  std::set<std::int64_t> known;
  for (std::size_t i = 0; i < count; ++i) {
    const vtkDICOMItem& item = segments.GetItem(i);
    Label label;
    label.value = static_cast<std::int64_t>(numberIn(item.Get(DC::SegmentNumber)).value_or(-1.0));
    label.name = textIn(item.Get(DC::SegmentLabel));
    label.color = colorOfLab(item.Get(DC::RecommendedDisplayCIELabValue));
    const std::int64_t least = file.kind == SegmentationKind::labelMap ? 0 : 1;
    if (label.value < least || label.value > 65535 || !known.insert(label.value).second)
      throwInput(file.name(), "SegmentSequence",
                 "segment " + std::to_string(i + 1) + " has no SegmentNumber of its own");
    file.segments.push_back(std::move(label));
  }
  if (file.segments.empty()) throwInput(file.name(), "SegmentSequence", "names no segments");
}

// An element of a frame's functional groups, else of those that all frames share.
const vtkDICOMValue& inGroups(vtkDICOMMetaData* meta, std::size_t frame, vtkDICOMTag sequence,
                              vtkDICOMTag tag) {
  const vtkDICOMValue& own = meta->Get(vtkDICOMTagPath(DC::PerFrameFunctionalGroupsSequence,
                                                       static_cast<unsigned int>(frame), sequence, 0, tag));
  return own.IsValid() ? own
                       : meta->Get(vtkDICOMTagPath(DC::SharedFunctionalGroupsSequence, 0, sequence, 0, tag));
}

void refuseSlides(vtkDICOMMetaData* meta, const Segmentation& file) {
  if (segmentText(meta, DC::DimensionOrganizationType).starts_with("TILED") ||
      meta->Has(DC::TotalPixelMatrixColumns) || meta->Has(DC::TotalPixelMatrixRows))
    throwInput(file.name(), "TotalPixelMatrixColumns",
               "the segmentation is of a whole-slide image (tiles), which is not read");
}

void readSegmentFrames(vtkDICOMMetaData* meta, int count, Segmentation& file) {
  const auto vector = [&](std::size_t frame, vtkDICOMTag sequence, vtkDICOMTag tag, std::size_t numbers) {
    return numbersIn(inGroups(meta, frame, sequence, tag), numbers);
  };
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const auto position = vector(i, DC::PlanePositionSequence, DC::ImagePositionPatient, 3);
    if (position.empty())
      throwInput(file.name(), "PlanePositionSequence",
                 "frame " + std::to_string(i + 1) + " states no position; its place is not known");
    SegmentFrame frame;
    frame.positionMm = {position[0], position[1], position[2]};
    if (file.kind != SegmentationKind::labelMap) {
      frame.segment = static_cast<int>(
          numberIn(inGroups(meta, i, DC::SegmentIdentificationSequence, DC::ReferencedSegmentNumber))
              .value_or(0.0));
      if (std::ranges::find(file.segments, frame.segment, &Label::value) == file.segments.end())
        throwInput(file.name(), "ReferencedSegmentNumber",
                   "frame " + std::to_string(i + 1) + " is of segment " + std::to_string(frame.segment) +
                       ", which SegmentSequence does not list");
    }
    const auto orientation = vector(i, DC::PlaneOrientationSequence, DC::ImageOrientationPatient, 6);
    if (orientation.empty())
      throwInput(file.name(), "PlaneOrientationSequence", "the orientation of frames is not stated");
    const glm::dvec3 row(orientation[0], orientation[1], orientation[2]),
        column(orientation[3], orientation[4], orientation[5]);
    if (i == 0) {
      file.row = row;
      file.column = column;
    } else if (glm::length(row - file.row) > 1e-3 || glm::length(column - file.column) > 1e-3) {
      throwInput(file.name(), "PlaneOrientationSequence", "frames are turned against each other");
    }
    file.frames.push_back(frame);
  }
  if (const auto spacing = vector(0, DC::PixelMeasuresSequence, DC::PixelSpacing, 2); !spacing.empty()) {
    file.spacingYMm = spacing[0];
    file.spacingXMm = spacing[1];
  }
  const auto measure = [&](vtkDICOMTag tag) {
    return std::abs(numberIn(inGroups(meta, 0, DC::PixelMeasuresSequence, tag)).value_or(0.0));
  };
  file.distanceMm = measure(DC::SpacingBetweenSlices);
  if (file.distanceMm == 0.0 && count == 1) file.distanceMm = measure(DC::SliceThickness);
}

SegmentationKind kindOf(vtkDICOMMetaData* meta, const Segmentation& file) {
  const std::string type = segmentText(meta, DC::SegmentationType);
  if (type == "BINARY") return SegmentationKind::binary;
  if (type == "FRACTIONAL") return SegmentationKind::fractional;
  if (type == "LABELMAP") return SegmentationKind::labelMap;
  throwInput(file.name(), "SegmentationType",
             inQuotes(type) + " of a segmentation (SEG) is not read; BINARY, FRACTIONAL and LABELMAP are");
}

void checkPixels(vtkDICOMMetaData* meta, std::size_t count, Segmentation& file) {
  const bool fits = file.kind == SegmentationKind::binary       ? file.bits == 1
                    : file.kind == SegmentationKind::fractional ? file.bits == 8
                                                                : file.bits == 8 || file.bits == 16;
  if (!fits || segmentInteger(meta, DC::SamplesPerPixel) > 1)
    throwInput(file.name(), "BitsAllocated",
               std::to_string(file.bits) + " bits are not those of a " +
                   segmentText(meta, DC::SegmentationType) + " segmentation");
  if (file.columns < 1 || file.rows < 1 || file.columns > 65535 || file.rows > 65535)
    throwInput(file.name(), "Rows, Columns", "the image has no pixels");
  if (file.compressed && file.kind == SegmentationKind::binary)
    throwInput(file.name(), "TransferSyntaxUID",
               "compressed BINARY segmentations are not read; convert it with gdcmconv --raw");
  const std::uint64_t bits = static_cast<std::uint64_t>(file.framePixels()) *
                             static_cast<std::uint64_t>(file.bits) * static_cast<std::uint64_t>(count);
  file.pixelBytes = (bits + 7) / 8;
  const std::uint64_t size = FileBytes(file.path).size();
  if (!file.compressed && (file.pixelsAt > size || file.pixelBytes > size - file.pixelsAt))
    throwInput(file.name(), "pixel data",
               "truncated: " + std::to_string(file.pixelBytes) + " bytes are announced, the file has " +
                   std::to_string(size - std::min(size, file.pixelsAt)));
  constexpr std::uint64_t bestRatio = 100000;  // of any compression
  if (file.compressed && file.pixelBytes / bestRatio > size)
    throwInput(file.name(), "pixel data", "truncated: the file cannot hold its frames");
}

Segmentation readSegmentation(const DicomFile& named) {
  const VtkMessages messages;
  Segmentation file;
  const fs::path& path = file.path = named.path;
  file.transferSyntax = named.transferSyntax;
  vtkNew<vtkDICOMMetaData> meta;
  meta->SetNumberOfInstances(1);
  vtkNew<vtkDICOMParser> parser;
  parser->SetMetaData(meta);
  parser->SetFileName(path.c_str());
  parser->Update();
  if (!messages.errors().empty()) throwInput(path.string(), "header", messages.errors().front());
  refuseSlides(meta, file);
  file.kind = kindOf(meta, file);
  if (!parser->GetPixelDataFound()) throwInput(path.string(), "pixel data", "are missing");
  if (file.transferSyntax == "1.2.840.10008.1.2.2")
    throwInput(path.string(), "TransferSyntaxUID",
               "big-endian segmentations are not read; convert it with gdcmconv --explicit");
  file.compressed = file.transferSyntax != "1.2.840.10008.1.2" &&
                    file.transferSyntax != "1.2.840.10008.1.2.1" && !file.transferSyntax.empty();
  file.columns = segmentInteger(meta, DC::Columns);
  file.rows = segmentInteger(meta, DC::Rows);
  file.bits = segmentInteger(meta, DC::BitsAllocated);
  file.pixelsAt = static_cast<std::uint64_t>(parser->GetFileOffset());
  const int count = std::max(1, segmentInteger(meta, DC::NumberOfFrames));
  if (count > 65535) throwInput(path.string(), "NumberOfFrames", "at most 65535 frames are read");
  checkPixels(meta, static_cast<std::size_t>(count), file);
  if (file.kind == SegmentationKind::fractional) {
    file.most = numberIn(meta->Get(DC::MaximumFractionalValue)).value_or(0.0);
    if (file.most < 1.0 || file.most > 255.0)
      throwInput(path.string(), "MaximumFractionalValue", "is missing, or not from 1 to 255");
  }
  readSegments(meta, file);
  readSegmentFrames(meta, count, file);
  return file;
}

// --- where frames lie

// Whether all distances are multiples of a step, which is known better with each: `tolerance` in steps.
bool areMultiples(const std::vector<double>& sorted, double step, double tolerance) {
  for (const double at : sorted) {
    const double distance = at - sorted.front(), steps = std::round(distance / step);
    if (std::abs(distance / step - steps) > tolerance) return false;
    if (steps > 0.0) step = distance / steps;
  }
  return true;
}

// The largest step of which all distances are multiples; 0: none that is not far smaller than the least.
double commonStep(const std::vector<double>& sorted) {
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 1; i < sorted.size(); ++i) least = std::min(least, sorted[i] - sorted[i - 1]);
  if (areMultiples(sorted, least, 0.1)) return least;
  constexpr int mostParts = 12;
  for (int parts = 2; parts <= mostParts; ++parts)
    if (areMultiples(sorted, least / parts, 0.02)) return least / parts;
  return 0.0;
}

// Sets the slices of frames and the geometry of `header`.
void placeFrames(Segmentation& file, ImageHeader& header) {
  const glm::dvec3 normal = glm::cross(file.row, file.column);
  if (!(std::abs(glm::length(normal) - 1.0) < 0.01))
    throwInput(file.name(), "ImageOrientationPatient", "rows and columns are not at right angles");
  const auto along = [&](const SegmentFrame& frame) { return glm::dot(frame.positionMm, normal); };
  constexpr double sameMm = 1e-3;
  std::vector<double> distances;
  for (const SegmentFrame& frame : file.frames) distances.push_back(along(frame));
  std::ranges::sort(distances);
  std::vector<double> places;  // each once
  for (const double distance : distances)
    if (places.empty() || distance - places.back() > sameMm) places.push_back(distance);
  double step = file.distanceMm;
  if (places.size() > 1 && (step <= sameMm || !areMultiples(places, step, 0.1))) {
    const double found = commonStep(places);
    if (found == 0.0)
      throwInput(file.name(), "PlanePositionSequence", "frames are unevenly spaced; no grid holds them");
    if (step > sameMm)
      header.warnings.push_back("SpacingBetweenSlices " + base::shortText(step) +
                                " mm contradicts the positions of frames; " + base::shortText(found) +
                                " mm is taken");
    step = found;
  }
  if (step <= sameMm) {
    step = 1.0;
    header.warnings.push_back("the distance of slices is missing; " + std::string(kSpacingAssumed));
  }
  const double slices = std::round((places.back() - places.front()) / step);
  if (!(slices < 65535.0))
    throwInput(file.name(), "PlanePositionSequence", "frames lie more than 65534 slices apart");
  if (slices > 0.0) step = (places.back() - places.front()) / slices;
  const auto [lowest, highest] = std::ranges::minmax_element(file.frames, {}, along);
  const glm::dvec3 origin = lowest->positionMm;
  const glm::dvec3 axis =
      slices > 0.0 ? (highest->positionMm - origin) / (slices * step) : normal;  // along `normal` it is 1
  const glm::dvec2 pixel(file.spacingXMm > 0.0 ? file.spacingXMm : 1.0,
                         file.spacingYMm > 0.0 ? file.spacingYMm : 1.0);
  if (file.spacingXMm <= 0.0 || file.spacingYMm <= 0.0)
    header.warnings.push_back("PixelSpacing is missing; " + std::string(kSpacingAssumed));
  for (SegmentFrame& frame : file.frames) {
    frame.slice = static_cast<int>(std::lround((along(frame) - places.front()) / step));
    const glm::dvec3 off = frame.positionMm - origin - axis * (frame.slice * step);
    if (std::abs(glm::dot(off, file.row)) > 0.5 * pixel.x ||
        std::abs(glm::dot(off, file.column)) > 0.5 * pixel.y)
      throwInput(file.name(), "PlanePositionSequence",
                 "frames lie more than half a pixel beside a common line; no grid holds them");
  }
  header.dims = {file.columns, file.rows, static_cast<std::int64_t>(slices) + 1};
  header.worldFromVoxel =
      checkedGeometry(glm::dmat3(file.row, file.column, glm::normalize(axis)),
                      {pixel.x, pixel.y, step * glm::length(axis)}, origin, file.name(), header.warnings);
  header.axes = scene::WorldAxes::anatomical;
}

// --- what frames hold

// The pixels of all frames as 8 or 16 bits.
class FramePixels {
 public:
  FramePixels(const Segmentation& file, base::Progress& progress) : file_(file), bytes_(file.path) {
    if (!file.compressed) return;
    DicomFile whole;
    whole.path = file.path;
    whole.transferSyntax = file.transferSyntax;
    whole.columns = file.columns;
    whole.rows = file.rows;
    whole.bitsAllocated = file.bits;
    whole.frames.resize(file.frames.size());
    allowDecoding(bytes_.size());
    const VtkMessages messages;
    decoded_ = decodeFiles({whole}, file.name(), messages, progress);
    const auto type = voxelTypeOf(decoded_);
    if (type != (file.bits == 8 ? VoxelType::uint8 : VoxelType::uint16))
      throwInput(file.name(), "pixel data", "are not decoded as stated");
  }

  // Calls use(pixel, value) for each pixel of the frame that is not 0.
  template <class Use>
  void forEach(std::size_t frame, const Use& use) {
    const std::size_t count = file_.framePixels();
    if (decoded_) {
      for (std::size_t i = 0; i < count; ++i)
        if (const auto value = static_cast<std::uint16_t>(
                decoded_->GetComponent(static_cast<vtkIdType>(frame * count + i), 0));
            value != 0)
          use(i, value);
      return;
    }
    const auto bits = static_cast<std::size_t>(file_.bits);
    const std::size_t firstBit = frame * count * bits, first = firstBit / 8,
                      last = (firstBit + count * bits + 7) / 8;
    buffer_.resize(last - first);
    bytes_.read(file_.pixelsAt + first, std::as_writable_bytes(std::span(buffer_)));
    for (std::size_t i = 0; i < count; ++i) {
      std::uint16_t value = 0;
      if (bits == 1) {
        const std::size_t bit = firstBit - 8 * first + i;
        value = buffer_[bit / 8] >> (bit % 8) & 1;
      } else if (bits == 8) {
        value = buffer_[i];
      } else {
        value = numberAt<std::uint16_t>(&buffer_[2 * i], false);
      }
      if (value != 0) use(i, value);
    }
  }

 private:
  const Segmentation& file_;
  FileBytes bytes_;
  vtkSmartPointer<vtkDataArray> decoded_;  // null: the file's bytes
  std::vector<std::uint8_t> buffer_;
};

// Puts each segment into the first layer in which all its voxels are free; returns the number of layers.
int packLayers(Segmentation& file, FramePixels& pixels, std::size_t voxels, std::size_t budgetBytes,
               base::Progress& progress) {
  std::vector<std::vector<bool>> layers;
  for (Label& segment : file.segments) {
    progress.throwIfStopped();
    const auto forEachVoxel = [&](const auto& use) {
      for (std::size_t frame = 0; frame < file.frames.size(); ++frame) {
        if (file.frames[frame].segment != segment.value) continue;
        const std::size_t begin = static_cast<std::size_t>(file.frames[frame].slice) * file.framePixels();
        pixels.forEach(frame, [&](std::size_t pixel, std::uint16_t) { use(begin + pixel); });
      }
    };
    const auto isFree = [&](const std::vector<bool>& layer) {
      bool free = true;
      forEachVoxel([&](std::size_t voxel) { free = free && !layer[voxel]; });
      return free;
    };
    const auto layer = std::ranges::find_if(layers, isFree);
    segment.layer = static_cast<int>(layer - layers.begin());
    if (layer == layers.end()) {
      if ((layers.size() + 1) * (voxels / 8) > budgetBytes)
        throw base::Error(base::ErrorKind::memory, file.name(), "",
                          "the layers of its overlapping segments need more memory than is left");
      layers.emplace_back(voxels);
    }
    std::vector<bool>& chosen = layers[static_cast<std::size_t>(segment.layer)];
    forEachVoxel([&](std::size_t voxel) { chosen[voxel] = true; });
  }
  return static_cast<int>(layers.size());
}

template <class T>
std::vector<T> voxelsOf(const Segmentation& file, FramePixels& pixels, const ImageHeader& header,
                        int component, base::Progress& progress) {
  std::vector<T> voxels(static_cast<std::size_t>(header.voxels()));
  std::set<std::pair<int, int>> filled;  // slices of segments
  for (std::size_t frame = 0; frame < file.frames.size(); ++frame) {
    progress.throwIfStopped();
    const SegmentFrame& place = file.frames[frame];
    const auto segment = std::ranges::find(file.segments, place.segment, &Label::value);
    const bool labelMap = file.kind == SegmentationKind::labelMap;
    const auto number = static_cast<int>(segment - file.segments.begin());
    if (file.kind == SegmentationKind::binary && segment->layer != component) continue;
    if (file.kind == SegmentationKind::fractional && number != component) continue;
    if (file.kind != SegmentationKind::binary && !filled.emplace(place.segment, place.slice).second)
      throwInput(
          file.name(), "PlanePositionSequence",
          "two frames of " + std::string(labelMap ? "the label map" : "a segment") + " lie at one place");
    T* const slice = voxels.data() + static_cast<std::size_t>(place.slice) * file.framePixels();
    const bool binary = file.kind == SegmentationKind::binary;
    pixels.forEach(frame, [&](std::size_t pixel, std::uint16_t value) {
      slice[pixel] = static_cast<T>(binary ? place.segment : value);
    });
  }
  return voxels;
}

void describeFractions(const Segmentation& file, ImageHeader& header) {
  header.components = static_cast<std::int64_t>(file.segments.size());
  header.slope = 1.0 / file.most;
  header.isovalue = 0.5;
  std::string names;
  for (std::size_t i = 0; i < std::min<std::size_t>(file.segments.size(), 5); ++i) {
    const Label& segment = file.segments[i];
    names += (i > 0 ? ", " : "") + std::to_string(i) + " is segment " + std::to_string(segment.value) +
             (segment.name.empty() ? "" : " (" + segment.name + ")");
  }
  if (file.segments.size() > 5) names += ", ...";
  header.warnings.push_back("values are shares of segments, from 0 to 1; component " + names);
}

}  // namespace

bool isSegmentationClass(std::string_view sopClass) {
  return sopClass == "1.2.840.10008.5.1.4.1.1.66.4" || sopClass == "1.2.840.10008.5.1.4.1.1.66.7";
}

DecodedVolume decodeSegmentation(const DicomFile& named, const ReadOptions& options,
                                 base::Progress& progress) {
  Segmentation file = readSegmentation(named);
  ImageHeader header;
  header.format = "DICOM SEG";
  placeFrames(file, header);
  std::int64_t greatest = 0;
  for (const Label& segment : file.segments) greatest = std::max(greatest, segment.value);
  const bool wide = file.bits == 16 || (file.kind == SegmentationKind::binary && greatest > 255);
  header.type = wide ? VoxelType::uint16 : VoxelType::uint8;
  checkDims(header, file.name(), "Rows, Columns, PlanePositionSequence");
  checkBudget(header, file.name(), options);
  if (file.compressed) checkBudget(file.pixelBytes, "the frames", "", file.name(), options);
  allowDecoding(FileBytes(file.path).size());
  FramePixels pixels(file, progress);
  if (file.kind == SegmentationKind::fractional) {
    describeFractions(file, header);
    if (options.component == -1)
      base::throwUsage(file.name(), "source.component",
                       "segments have no magnitude; choose one, 0 is the first");
  } else {
    if (file.kind == SegmentationKind::binary)
      header.components =
          packLayers(file, pixels, static_cast<std::size_t>(header.voxels()), options.budgetBytes, progress);
    header.labels =
        std::make_shared<const LabelTable>(LabelTable{"it is a DICOM segmentation", "", file.segments});
  }
  checkChoices(header, file.name(), options);
  FileVoxels voxels;
  if (wide)
    voxels = voxelsOf<std::uint16_t>(file, pixels, header, options.component, progress);
  else
    voxels = voxelsOf<std::uint8_t>(file, pixels, header, options.component, progress);
  return {std::move(header), std::move(voxels), named.description, {}, named.patient};
}

}  // namespace isolux::readers
