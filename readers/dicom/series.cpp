#include "readers/dicom/series.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <glm/geometric.hpp>

#include "base/error.h"

namespace isolux::readers {

using namespace volume;
using base::throwInput;

namespace {

// What slices of one volume must share. Directions are compared to 1e-3.
auto kindOf(const DicomFile& file, const DicomFrame& frame) {
  const auto key = [](double v) { return std::lround(v * 1000.0); };
  const glm::dvec3 r = frame.rowDirection, c = frame.columnDirection;
  return std::tuple(file.columns, file.rows, file.samples, file.bitsAllocated, file.isSigned,
                    frame.hasPosition, key(frame.spacingXMm), key(frame.spacingYMm),
                    std::tuple(key(r.x), key(r.y), key(r.z)), std::tuple(key(c.x), key(c.y), key(c.z)));
}

}  // namespace

std::vector<DicomFile> keepMajority(std::vector<DicomFile> files, std::vector<std::string>& warnings) {
  using Kind = decltype(kindOf(files[0], files[0].frames[0]));
  std::map<Kind, std::size_t> count;
  for (const DicomFile& file : files)
    for (const DicomFrame& frame : file.frames) ++count[kindOf(file, frame)];
  if (count.size() == 1) return files;
  const auto most = std::max_element(count.begin(), count.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  std::size_t all = 0;
  for (const auto& [kind, n] : count) all += n;
  std::erase_if(files, [&](const DicomFile& file) {
    return std::none_of(file.frames.begin(), file.frames.end(),
                        [&](const DicomFrame& frame) { return kindOf(file, frame) == most->first; });
  });
  for (const DicomFile& file : files)
    for (const DicomFrame& frame : file.frames)
      if (kindOf(file, frame) != most->first)
        throwInput(file.path.string(), "frames", "the frames of one file differ in orientation or spacing");
  warnings.push_back(std::to_string(all - most->second) + " of " + std::to_string(all) +
                     " slices differ in size, type or orientation from the rest and are left out");
  return files;
}

std::vector<DicomSource> sourcesOf(const std::vector<DicomFile>& files) {
  std::vector<DicomSource> sources;
  for (std::size_t f = 0; f < files.size(); ++f)
    for (std::size_t frame = 0; frame < files[f].frames.size(); ++frame)
      sources.push_back({&files[f], f, frame});
  return sources;
}

SliceStack stackOf(const std::vector<DicomSource>& sources, const std::string& folder,
                   std::vector<std::string>& warnings) {
  SlicePlanes planes;
  const DicomFrame& first = sources.front().frame();
  const auto spacing = [&](double value, const char* name) {
    if (value > 0.0) return value;
    warnings.push_back(std::string(name) + " is missing or not positive; 1 mm assumed");
    return 1.0;
  };
  planes.spacingXMm = spacing(first.spacingXMm, "PixelSpacing along x");
  planes.spacingYMm = spacing(first.spacingYMm, "PixelSpacing along y");
  if (sources.size() == 1 || !first.hasPosition)
    planes.thicknessMm = spacing(first.thicknessMm, "SliceThickness");
  if (!first.hasPosition) {
    warnings.push_back(
        "no slice has a position and an orientation; the order of the instance numbers is used");
    for (std::size_t i = 0; i < sources.size(); ++i)
      planes.positionsMm.emplace_back(0.0, 0.0, static_cast<double>(i) * planes.thicknessMm);
    return stackSlices(planes, folder);
  }
  const double lengths = glm::length(first.rowDirection) * glm::length(first.columnDirection);
  const double cosine = glm::dot(first.rowDirection, first.columnDirection);
  if (!(lengths > 1e-6) || std::abs(cosine) > 0.01 * lengths)
    throwInput(folder, "ImageOrientationPatient", "row and column directions are not perpendicular");
  planes.rowDirection = glm::normalize(first.rowDirection);
  planes.columnDirection = glm::normalize(first.columnDirection);
  for (const DicomSource& source : sources) planes.positionsMm.push_back(source.frame().positionMm);
  return stackSlices(planes, folder);
}

}  // namespace isolux::readers
