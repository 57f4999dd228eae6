#include "readers/dicom/series.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "base/words.h"
#include "volume/read/input/spacing_reliability.h"
#include "volume/read/input/text.h"

namespace isolux::readers {

using namespace volume;
using base::throwInput;

namespace {

constexpr double sameDirection = 1e-3, sameSpacing = 1e-3;  // of a unit vector's components; relative
constexpr std::size_t mostKinds = 1000;                     // of slices in one series

// What two slices of one volume must share and do not.
std::vector<std::string> differences(const DicomSource& a, const DicomSource& b) {
  const DicomFile &file = *a.file, &other = *b.file;
  const DicomFrame &frame = a.frame(), &second = b.frame();
  std::vector<std::string> names;
  const auto note = [&](bool differ, const char* name) {
    if (differ) names.emplace_back(name);
  };
  const auto apart = [](const glm::dvec3& u, const glm::dvec3& v) {
    return !(std::max({std::abs(u.x - v.x), std::abs(u.y - v.y), std::abs(u.z - v.z)}) <= sameDirection);
  };
  const auto far = [](double u, double v) { return !(std::abs(u - v) <= sameSpacing * std::max(u, v)); };
  note(file.columns != other.columns || file.rows != other.rows || file.tilesAcross != other.tilesAcross,
       "size");
  note(file.samples != other.samples || file.bitsAllocated != other.bitsAllocated ||
           file.isSigned != other.isSigned,
       "type");
  note(file.photometric != other.photometric, "photometric interpretation");
  note(file.patient.id != other.patient.id, "patient");
  note(frame.hasPosition != second.hasPosition, "having a position");
  note(far(frame.spacingXMm, second.spacingXMm) || far(frame.spacingYMm, second.spacingYMm), "pixel spacing");
  note(apart(frame.rowDirection, second.rowDirection) || apart(frame.columnDirection, second.columnDirection),
       "orientation");
  return names;
}

bool isCopy(const DicomFile& a, const DicomFile& b) {
  return a.instance == b.instance && std::equal(a.frames.begin(), a.frames.end(), b.frames.begin(),
                                                b.frames.end(), [](const DicomFrame& x, const DicomFrame& y) {
                                                  return x.positionMm == y.positionMm && x.tags == y.tags;
                                                });
}

void dropCopies(std::vector<DicomFile>& files, std::vector<std::string>& warnings) {
  std::map<std::string, const DicomFile*> seen;
  std::set<const DicomFile*> copies;
  std::size_t clashes = 0;
  for (const DicomFile& file : files) {
    if (file.instanceUid.empty()) continue;
    const auto [known, isNew] = seen.emplace(file.instanceUid, &file);
    if (isNew) continue;
    if (isCopy(*known->second, file))
      copies.insert(&file);
    else
      ++clashes;
  }
  if (clashes > 0)
    warnings.push_back(std::to_string(clashes) +
                       " files have the SOPInstanceUID of a different image; all are used");
  if (copies.empty()) return;
  warnings.push_back(std::to_string(copies.size()) +
                     " files are copies of others (the same SOPInstanceUID) and are left out");
  std::vector<DicomFile> kept;
  for (DicomFile& file : files)
    if (!copies.contains(&file)) kept.push_back(std::move(file));
  files = std::move(kept);
}

// Without positions, several files over time are clips, each by itself.
void keepOneClip(std::vector<DicomFile>& files, std::vector<std::string>& warnings) {
  const auto clip = std::ranges::find_if(
      files, [](const DicomFile& file) { return file.isCine && !file.frames.front().hasPosition; });
  if (clip == files.end() || files.size() == 1) return;
  warnings.push_back(
      std::to_string(files.size() - 1) +
      " other files of the series are images of their own and left out; name the file to open one");
  std::vector<DicomFile> kept{std::move(*clip)};
  files = std::move(kept);
}

// What the files say of themselves, each remark once, and whether they say they belong together.
void noteRemarks(const std::vector<DicomFile>& files, std::vector<std::string>& warnings) {
  std::map<std::string, std::size_t> remarks;
  for (const DicomFile& file : files)
    for (const std::string& remark : file.warnings) ++remarks[remark];
  for (const auto& [remark, count] : remarks)
    warnings.push_back(count == files.size() ? remark
                                             : remark + " (" + std::to_string(count) + " of " +
                                                   std::to_string(files.size()) + " files)");
  const auto differ = [&](const auto& value) {
    return std::ranges::any_of(files,
                               [&](const DicomFile& file) { return !(value(file) == value(files.front())); });
  };
  if (files.front().series == kNoSeries && files.size() > 1)
    warnings.emplace_back("its files state no SeriesInstanceUID; they may not belong together");
  if (differ([](const DicomFile& file) { return file.patient; }))
    warnings.emplace_back("its files name several patients");
  if (differ([](const DicomFile& file) { return file.frameOfReference; }))
    warnings.emplace_back("its files name several frames of reference: their positions may not fit together");
}

// The slices of one kind, and how many there are.
struct Kind {
  DicomSource first;
  std::size_t count = 0;
};

// The kinds of slices, and that of each source.
std::vector<Kind> kindsOf(const std::vector<DicomSource>& sources, std::vector<std::size_t>& kindOfSource) {
  std::vector<Kind> kinds;
  for (const DicomSource& source : sources) {
    auto kind = std::ranges::find_if(
        kinds, [&](const Kind& known) { return differences(known.first, source).empty(); });
    if (kind == kinds.end()) {
      if (kinds.size() == mostKinds)
        throwInput(source.file->path.string(), "",
                   "its series has more than 1000 sizes or orientations of slices");
      kind = kinds.insert(kinds.end(), {source, 0});
    }
    ++kind->count;
    kindOfSource.push_back(static_cast<std::size_t>(kind - kinds.begin()));
  }
  return kinds;
}

void keepLargestKind(std::vector<DicomFile>& files, std::vector<std::string>& warnings) {
  const std::vector<DicomSource> sources = sourcesOf(files);
  std::vector<std::size_t> kindOfSource;
  const std::vector<Kind> kinds = kindsOf(sources, kindOfSource);
  if (kinds.size() == 1) return;
  const auto most =
      std::ranges::max_element(kinds, [](const Kind& a, const Kind& b) { return a.count < b.count; });
  std::set<std::string> names;
  for (const Kind& kind : kinds)
    for (std::string& name : differences(most->first, kind.first)) names.insert(std::move(name));
  std::vector<std::size_t> fitting(files.size(), 0);
  for (std::size_t i = 0; i < sources.size(); ++i)
    if (kindOfSource[i] == static_cast<std::size_t>(most - kinds.begin())) ++fitting[sources[i].fileIndex];
  std::vector<DicomFile> kept;
  for (std::size_t f = 0; f < files.size(); ++f) {
    if (fitting[f] == 0) continue;
    if (fitting[f] != files[f].frames.size())
      throwInput(files[f].path.string(), "frames", "the frames of one file differ in " + base::joined(names));
    kept.push_back(std::move(files[f]));
  }
  warnings.push_back(std::to_string(sources.size() - most->count) + " of " + std::to_string(sources.size()) +
                     " slices differ from the rest (" + base::joined(names) + ") and are left out");
  files = std::move(kept);
}

}  // namespace

std::vector<DicomFile> onlyScans(std::vector<DicomFile> files) {
  const DicomFile first = files.front();
  std::erase_if(files, [](const DicomFile& file) { return !file.notAScan.empty(); });
  if (files.empty()) throwInput(first.path.string(), "SOPClassUID", first.notAScan);
  return files;
}

std::vector<DicomFile> keepMajority(std::vector<DicomFile> files, std::vector<std::string>& warnings) {
  dropCopies(files, warnings);
  keepOneClip(files, warnings);
  keepLargestKind(files, warnings);
  noteRemarks(files, warnings);
  return files;
}

std::vector<DicomSource> sourcesOf(const std::vector<DicomFile>& files) {
  std::vector<DicomSource> sources;
  std::size_t pixels = 0;
  for (std::size_t f = 0; f < files.size(); ++f) {
    for (std::size_t frame = 0; frame < files[f].frames.size(); ++frame)
      sources.push_back({&files[f], f, frame, pixels});
    pixels += files[f].decodedPixels();
  }
  return sources;
}

SliceStack stackOf(const std::vector<DicomSource>& sources, const std::string& folder,
                   std::vector<std::string>& warnings) {
  SlicePlanes planes;
  const DicomFrame& first = sources.front().frame();
  const auto spacing = [&](double value, const char* name, double otherwise = 1.0) {
    if (value > 0.0) return value;
    warnings.push_back(std::string(name) + " is missing or not positive; " + std::string(kSpacingAssumed));
    return otherwise;
  };
  planes.spacingXMm = spacing(first.spacingXMm, "PixelSpacing along x");
  planes.spacingYMm = spacing(first.spacingYMm, "PixelSpacing along y", sources.front().file->pixelAspect);
  planes.thicknessMm = first.thicknessMm;
  for (const DicomSource& source : sources) planes.tags.push_back(source.frame().tags);
  if (!first.hasPosition) {
    const bool isCine = sources.front().file->isCine;
    if (!isCine && sources.size() > 1) planes.thicknessMm = spacing(first.thicknessMm, "SliceThickness");
    const bool isOneFile = sources.back().fileIndex == 0;
    const bool isNumbered = sources.front().file->instance != sources.back().file->instance;
    const std::string order = isOneFile ? "frames" : isNumbered ? "instance numbers" : "file names";
    warnings.push_back("no slice has a position and an orientation" +
                       (isCine || sources.size() == 1
                            ? std::string()
                            : "; the order of the " + order + " is used: it may be a mirror image"));
    for (std::size_t i = 0; i < sources.size(); ++i)
      planes.positionsMm.emplace_back(0.0, 0.0, isCine ? 0.0 : static_cast<double>(i) * planes.thicknessMm);
    return stackSlices(planes, folder);
  }
  const double lengths = glm::length(first.rowDirection) * glm::length(first.columnDirection);
  const double cosine = glm::dot(first.rowDirection, first.columnDirection);
  if (!(lengths > 1e-6) || std::abs(cosine) > 0.01 * lengths)
    throwInput(folder, "ImageOrientationPatient", "row and column directions are not perpendicular");
  planes.rowDirection = glm::normalize(first.rowDirection);
  planes.columnDirection = glm::normalize(first.columnDirection);
  planes.distanceMm = first.distanceMm;
  for (const DicomSource& source : sources) planes.positionsMm.push_back(source.frame().positionMm);
  return stackSlices(planes, folder);
}

}  // namespace isolux::readers
