#include "readers/dicom/frames.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>

#include <glm/geometric.hpp>

#include <vtkDICOMItem.h>
#include <vtkDICOMMetaData.h>
#include <vtkDICOMTagPath.h>
#include <vtkDICOMValue.h>

#include "base/error.h"
#include "base/number_text.h"
#include "readers/dicom/dicom.h"
#include "readers/dicom/elements.h"

namespace isolux::readers {

using base::throwInput;

namespace {

// The elements of one frame: of its functional groups, else of the file.
class FrameElements {
 public:
  FrameElements(vtkDICOMMetaData* meta, int frame) : meta_(meta), frame_(frame) {}

  const vtkDICOMValue& get(vtkDICOMTag tag) const { return meta_->Get(0, frame_, tag); }
  std::vector<double> numbers(vtkDICOMTag tag, std::size_t count) const { return numbersIn(get(tag), count); }
  std::optional<double> number(vtkDICOMTag tag) const { return numberIn(get(tag)); }
  const vtkDICOMValue& at(const vtkDICOMTagPath& path) const { return meta_->Get(0, frame_, path); }
  // Of the first tag that is stated.
  std::string text(std::initializer_list<vtkDICOMTag> tags) const {
    for (const vtkDICOMTag tag : tags)
      if (std::string found = textIn(get(tag)); !found.empty()) return found;
    return {};
  }
  std::string privateText(vtkDICOMTag tag, const char* creator) const {
    return textIn(get(meta_->ResolvePrivateTag(tag, creator)));
  }

 private:
  vtkDICOMMetaData* meta_;
  int frame_;
};

// A unit as people write it.
std::string unitNamed(const std::string& stated) {
  constexpr std::pair<const char*, const char*> names[] = {
      {"US", ""},      {"normalized", ""}, {"RELATIVE", ""}, {"BQML", "Bq/ml"}, {"CNTS", "counts"},
      {"GML", "g/ml"}, {"GY", "Gy"},       {"NONE", ""},     {"1", ""},         {"[hnsf'U]", "HU"}};
  for (const auto& [known, written] : names)
    if (stated == known) return written;
  const bool isPlain =
      stated.size() <= 16 && std::ranges::all_of(stated, [](char c) { return c > ' ' && c < 127; });
  return isPlain ? stated : std::string();
}

volume::ImageTags tagsOf(const FrameElements& elements) {
  volume::ImageTags tags;
  tags[volume::kImageType] = elements.text({DC::FrameType, DC::ImageType});
  for (const vtkDICOMTag tag : {vtkDICOMTag(DC::ComplexImageComponent), vtkDICOMTag(DC::RescaleType)})
    if (const std::string more = elements.text({tag}); !more.empty()) tags[volume::kImageType] += " " + more;
  std::string& bValue = tags[volume::kBValue];
  bValue = elements.text({DC::DiffusionBValue});
  if (bValue.empty()) bValue = elements.privateText(vtkDICOMTag(0x0019, 0x000c), "SIEMENS MR HEADER");
  if (bValue.empty()) bValue = elements.privateText(vtkDICOMTag(0x2001, 0x0003), "Philips Imaging DD 001");
  if (bValue.empty()) bValue = elements.privateText(vtkDICOMTag(0x0065, 0x0009), "Image Private Header");
  tags[volume::kGradient] = elements.text({DC::DiffusionGradientOrientation});
  tags[volume::kEcho] = elements.text({DC::EffectiveEchoTime, DC::EchoTime, DC::EchoNumbers});
  tags[volume::kTemporal] = elements.text({DC::TemporalPositionIndex, DC::TemporalPositionIdentifier});
  tags[volume::kAcquisition] = elements.text({DC::FrameAcquisitionNumber, DC::AcquisitionNumber});
  tags[volume::kTrigger] =
      elements.text({DC::NominalCardiacTriggerDelayTime, DC::TriggerTime, DC::NominalPercentageOfCardiacPhase,
                     DC::NominalPercentageOfRespiratoryPhase, DC::FrameReferenceTime});
  tags[volume::kTime] = elements.text(
      {DC::FrameAcquisitionDateTime, DC::AcquisitionDateTime, DC::AcquisitionTime, DC::ContentTime});
  return tags;
}

// Slope, intercept and unit of values: of the rescale, else of the real world values.
void setScaling(const FrameElements& elements, DicomFile& file, DicomFrame& frame) {
  const auto slope = elements.number(DC::RescaleSlope), intercept = elements.number(DC::RescaleIntercept);
  const std::string unit = elements.text({DC::RescaleType, DC::Units, DC::DoseUnits});
  frame.unit = unit.empty() && file.modality == "CT" ? "HU" : unitNamed(unit);
  if (slope || intercept) {
    frame.slope = slope.value_or(1.0);
    frame.intercept = intercept.value_or(0.0);
  } else if (const auto dose = elements.number(DC::DoseGridScaling)) {
    frame.slope = *dose;
  } else {
    constexpr DC::EnumType mapping = DC::RealWorldValueMappingSequence;
    const auto real = [&](vtkDICOMTag tag) {
      return numberIn(elements.at(vtkDICOMTagPath(mapping, 0, tag)));
    };
    if (const auto realSlope = real(DC::RealWorldValueSlope)) {
      frame.slope = *realSlope;
      frame.intercept = real(DC::RealWorldValueIntercept).value_or(0.0);
      const vtkDICOMTagPath code(mapping, 0, DC::MeasurementUnitsCodeSequence, 0, DC::CodeValue);
      if (const std::string realUnit = textIn(elements.at(code)); !realUnit.empty())
        frame.unit = unitNamed(realUnit);
    } else if (real(DC::RealWorldValueLUTData) && file.frames.empty()) {
      file.warnings.emplace_back("its RealWorldValueMapping is a table, which is not applied");
    }
  }
  if (frame.slope == 0.0) frame.slope = 1.0;
}

DicomFrame frameOf(vtkDICOMMetaData* meta, int index, DicomFile& file) {
  const FrameElements elements(meta, index);
  DicomFrame frame;
  setPosition(elements.numbers(DC::ImagePositionPatient, 3), elements.numbers(DC::ImageOrientationPatient, 6),
              frame);
  for (const vtkDICOMTag tag : {DC::PixelSpacing, DC::ImagerPixelSpacing, DC::NominalScannedPixelSpacing})
    if (const auto spacing = elements.numbers(tag, 2); !spacing.empty()) {
      frame.spacingYMm = spacing[0];  // between rows, so along y
      frame.spacingXMm = spacing[1];
      break;
    }
  frame.distanceMm = elements.number(DC::SpacingBetweenSlices).value_or(0.0);
  frame.thicknessMm = std::abs(frame.distanceMm);
  if (frame.thicknessMm == 0.0)
    frame.thicknessMm = std::abs(elements.number(DC::SliceThickness).value_or(0.0));
  setScaling(elements, file, frame);
  frame.tags = tagsOf(elements);
  return frame;
}

// Pixels of an ultrasound image, from its first region whose unit is cm.
void readRegions(vtkDICOMMetaData* meta, DicomFile& file) {
  constexpr int centimetres = 3;
  const vtkDICOMValue& regions = meta->Get(DC::SequenceOfUltrasoundRegions);
  double x = 0.0, y = 0.0;
  bool differ = false;
  for (std::size_t i = 0; regions.IsValid() && i < regions.GetNumberOfValues(); ++i) {
    const vtkDICOMItem& region = regions.GetItem(i);
    const auto dx = numberIn(region.Get(DC::PhysicalDeltaX)), dy = numberIn(region.Get(DC::PhysicalDeltaY));
    if (numberIn(region.Get(DC::PhysicalUnitsXDirection)) != centimetres ||
        numberIn(region.Get(DC::PhysicalUnitsYDirection)) != centimetres || !dx || !dy)
      continue;
    const double thisX = 10.0 * std::abs(*dx), thisY = 10.0 * std::abs(*dy);
    if (x > 0.0) differ = differ || std::abs(thisX - x) > 1e-3 * x || std::abs(thisY - y) > 1e-3 * y;
    if (x == 0.0) {
      x = thisX;
      y = thisY;
    }
  }
  if (differ)
    file.warnings.emplace_back(
        "ultrasound regions have pixels of different sizes; that of the first one is used");
  for (DicomFrame& frame : file.frames) {
    frame.spacingXMm = x;
    frame.spacingYMm = y;
  }
}

void readPixelSize(vtkDICOMMetaData* meta, DicomFile& file) {
  if (file.frames.front().spacingXMm == 0.0) readRegions(meta, file);
  if (file.frames.front().spacingXMm == 0.0)
    if (const auto ratio = numbersIn(meta->Get(DC::PixelAspectRatio), 2); !ratio.empty() && ratio[0] > 0.0)
      if (ratio[1] > 0.0) file.pixelAspect = ratio[0] / ratio[1];
  if (!numbersIn(meta->Get(0, 0, DC::PixelSpacing), 2).empty()) return;
  if (!numbersIn(meta->Get(DC::ImagerPixelSpacing), 2).empty())
    file.warnings.emplace_back(
        "ImagerPixelSpacing is the size of a pixel at the detector, not in the object");
}

bool pointsTo(vtkDICOMMetaData* meta, vtkDICOMTag tag) {
  const vtkDICOMValue& pointer = meta->Get(DC::FrameIncrementPointer);
  for (std::size_t i = 0; pointer.IsValid() && i < pointer.GetNumberOfValues(); ++i)
    if (pointer.GetTag(i) == tag) return true;
  return false;
}

bool framesAreMoments(vtkDICOMMetaData* meta) {
  if (pointsTo(meta, DC::FrameTime) || pointsTo(meta, DC::FrameTimeVector)) return true;
  if (meta->Has(DC::FrameIncrementPointer) || meta->Has(DC::SpacingBetweenSlices)) return false;
  return meta->Has(DC::FrameTime) || meta->Has(DC::FrameTimeVector) || meta->Has(DC::CineRate);
}

// Distances of the frames from the first one along the normal; empty: not stated.
std::vector<double> frameOffsets(vtkDICOMMetaData* meta, const DicomFile& file, const glm::dvec3& normal) {
  const std::size_t count = file.frames.size();
  for (const vtkDICOMTag tag : {DC::GridFrameOffsetVector, DC::SliceLocationVector})
    if (std::vector<double> offsets = numbersIn(meta->Get(tag), count); !offsets.empty()) {
      // Offsets that do not begin with 0 are coordinates along z (PS3.3 C.8.8.3.2).
      const double first = offsets.front(), along = first == 0.0 ? 1.0 : normal.z;
      for (double& offset : offsets) offset = (offset - first) * along;
      return offsets;
    }
  const double distance = file.frames.front().distanceMm;
  if (const std::vector<double> slices = numbersIn(meta->Get(DC::SliceVector), count);
      distance != 0.0 && !slices.empty()) {
    std::vector<double> offsets;
    for (const double slice : slices) offsets.push_back((slice - 1.0) * distance);
    return offsets;
  }
  return {};
}

// One position for a file of several frames.
void spreadFrames(vtkDICOMMetaData* meta, DicomFile& file) {
  const DicomFrame first = file.frames.front();
  const glm::dvec3 normal = glm::cross(first.rowDirection, first.columnDirection);
  std::vector<double> offsets = frameOffsets(meta, file, normal);
  if (offsets.empty()) {
    const double distance = first.distanceMm != 0.0 ? first.distanceMm : first.thicknessMm;
    if (distance == 0.0)
      throwInput(file.path.string(), "frames", "have one position, and no distance between them is stated");
    for (std::size_t i = 0; i < file.frames.size(); ++i) offsets.push_back(distance * static_cast<double>(i));
    file.warnings.push_back("frames have one position; placed every " + base::shortText(distance, 4) +
                            " mm by " +
                            (first.distanceMm != 0.0 ? "SpacingBetweenSlices" : "SliceThickness"));
  }
  for (std::size_t i = 0; i < file.frames.size(); ++i) {
    file.frames[i].positionMm += normal * offsets[i];
    file.frames[i].distanceMm = 0.0;  // nothing to compare positions with
  }
}

// Nuclear medicine: which image of a frame, by the vectors that its FrameIncrementPointer names.
void readNuclearFrames(vtkDICOMMetaData* meta, DicomFile& file) {
  const std::string type = textIn(meta->Get(DC::ImageType));
  const bool areSlices = pointsTo(meta, DC::SliceVector) || type.find("RECON") != std::string::npos;
  if (!areSlices && !type.empty() && file.frames.size() > 1)
    throwInput(file.path.string(), "ImageType", "frames are views or projections (" + type + "), not slices");
  const vtkDICOMTagPath position(DC::DetectorInformationSequence, 0, DC::ImagePositionPatient);
  const vtkDICOMTagPath orientation(DC::DetectorInformationSequence, 0, DC::ImageOrientationPatient);
  const std::size_t count = file.frames.size();
  const auto windows = numbersIn(meta->Get(DC::EnergyWindowVector), count);
  const auto intervals = numbersIn(meta->Get(DC::RRIntervalVector), count);
  const auto slots = numbersIn(meta->Get(DC::TimeSlotVector), count);
  for (std::size_t i = 0; i < count; ++i) {
    DicomFrame& frame = file.frames[i];
    if (!frame.hasPosition)
      setPosition(numbersIn(meta->Get(position), 3), numbersIn(meta->Get(orientation), 6), frame);
    if (!windows.empty())
      frame.tags[volume::kImageType] += " energy window " + std::to_string(static_cast<int>(windows[i]));
    const double interval = intervals.empty() ? 0.0 : intervals[i], slot = slots.empty() ? 0.0 : slots[i];
    if (!intervals.empty() || !slots.empty())
      frame.tags[volume::kTemporal] = std::to_string(static_cast<int>(interval * 65536.0 + slot));
  }
}

}  // namespace

void setPosition(const std::vector<double>& position, const std::vector<double>& orientation,
                 DicomFrame& frame) {
  if (position.empty() || orientation.empty()) return;
  frame.positionMm = {position[0], position[1], position[2]};
  frame.rowDirection = {orientation[0], orientation[1], orientation[2]};
  frame.columnDirection = {orientation[3], orientation[4], orientation[5]};
  frame.hasPosition = true;
}

void readFrames(vtkDICOMMetaData* meta, int count, DicomFile& file) {
  for (int index = 0; index < count; ++index) file.frames.push_back(frameOf(meta, index, file));
  readPixelSize(meta, file);
  if (file.modality == "NM") readNuclearFrames(meta, file);
  const vtkDICOMTagPath ownPosition(DC::PerFrameFunctionalGroupsSequence, 0, DC::PlanePositionSequence, 0,
                                    DC::ImagePositionPatient);
  if (count < 2 || meta->Get(ownPosition).IsValid()) return;
  file.isCine = framesAreMoments(meta);
  if (file.isCine) {
    for (int i = 0; i < count; ++i)
      file.frames[static_cast<std::size_t>(i)].tags[volume::kTemporal] = std::to_string(i + 1);
  } else if (file.frames.front().hasPosition) {
    spreadFrames(meta, file);
  }
}

}  // namespace isolux::readers
