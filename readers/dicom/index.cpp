// The series of a folder by their headers.
#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "readers/dicom/dicom.h"
#include "readers/dicom/series.h"
#include "readers/limits.h"
#include "readers/serve.h"
#include "volume/read/dicom/dicom_files.h"
#include "volume/read/input/bytes.h"

namespace isolux::readers {

using namespace volume;
namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto tellEvery = std::chrono::milliseconds(700);  // while a folder is looked at

// The deepest folder that both are in.
fs::path commonFolder(const fs::path& a, const fs::path& b) {
  fs::path common;
  for (auto x = a.begin(), y = b.begin(); x != a.end() && y != b.end() && *x == *y; ++x, ++y) common /= *x;
  return common;
}

// What opening it would find; leaves the order of the slices in `sources`.
void describeGrid(const std::vector<DicomFile>& files, DicomSeries& series) {
  const std::vector<DicomFile> kept = keepMajority(files, series.warnings);
  const std::vector<DicomSource> sources = sourcesOf(kept);
  const DicomFile& first = kept.front();
  series.columns = first.columns;
  series.rows = first.rows;
  series.slices = static_cast<std::int64_t>(sources.size());
  const auto setMiddle = [&](std::size_t source) {
    series.middleFile = sources[source].file->path.string();
    series.middleFrame = static_cast<int>(sources[source].frameIndex);
  };
  setMiddle(sources.size() / 2);
  const SliceStack stack = stackOf(sources, series.folder, series.warnings);
  series.warnings.insert(series.warnings.end(), stack.warnings.begin(), stack.warnings.end());
  setMiddle(stack.order[stack.sourceSlices() / 2]);
  series.slices = static_cast<std::int64_t>(stack.sourceSlices());
  series.timeSteps = static_cast<std::int64_t>(stack.timeSteps);
  for (int axis = 0; axis < 3; ++axis)
    series.spacingMm[axis] = glm::length(glm::dvec3(stack.worldFromVoxel[axis]));
  if (!voxelTypeOf(first)) series.problem = std::to_string(first.bitsAllocated) + " bits are not supported";
}

DicomSeries describeSeries(std::vector<DicomFile> files) {
  // As when it is opened: in the order of acquisition.
  std::ranges::stable_sort(files,
                           [](const DicomFile& a, const DicomFile& b) { return a.instance < b.instance; });
  const DicomFile& first = files.front();
  DicomSeries series;
  static_cast<DicomStatements&>(series) = first;
  if (series.date.empty()) series.date = first.studyDate;
  fs::path folder = first.path.parent_path();
  for (const DicomFile& file : files) {
    folder = commonFolder(folder, file.path.parent_path());
    if (series.description.empty()) series.description = file.description;
  }
  series.folder = folder.string();
  try {
    describeGrid(onlyScans(files), series);
  } catch (const base::Error& error) {
    series.problem = error.reason();
  }
  return series;
}

class Index {
 public:
  explicit Index(const std::function<void(const DicomSeries&)>& found) : found_(found) {}

  void add(DicomFile file) {
    changed_.insert(file.series);
    all_[file.series].push_back(std::move(file));
  }
  void tell() {
    for (const std::string& uid : changed_) found_(describeSeries(all_[uid]));
    changed_.clear();
    lastTold_ = Clock::now();
  }
  void tellSometimes() {
    if (Clock::now() - lastTold_ > tellEvery) tell();
  }

 private:
  const std::function<void(const DicomSeries&)>& found_;
  std::map<std::string, std::vector<DicomFile>> all_;
  std::set<std::string> changed_;
  Clock::time_point lastTold_ = Clock::now();
};

// Nothing: no image.
std::optional<DicomFile> lookAt(const fs::path& path) {
  allowHeaders(1, FileBytes(path).size());  // each has its own time: one that spins ends soon
  nowReading(path);
  DicomFile file = readWholeHeader(path);
  if (file.frames.empty()) return std::nullopt;
  return file;
}

}  // namespace

DicomIndexEnd indexDicomFolder(const fs::path& folder, const std::vector<std::string>& skip,
                               const std::function<void(const DicomSeries&)>& found,
                               base::Progress& progress) {
  const std::vector<fs::path> paths = filesBelow(folder, kDeepestDicomFolder);
  DicomIndexEnd end;
  end.files = static_cast<std::int64_t>(paths.size());
  Index index(found);
  fs::path at;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const fs::path& path = paths[i];
    progress.throwIfStopped();
    progress.report(static_cast<double>(i) / static_cast<double>(paths.size()), "reading");
    if (path.parent_path() != at) index.tell();
    at = path.parent_path();
    if (!isDicomFile(path) || std::ranges::find(skip, path.string()) != skip.end()) continue;
    ++end.dicomFiles;
    try {
      if (auto file = lookAt(path)) index.add(std::move(*file));
    } catch (const base::Error& error) {
      if (error.kind() != base::ErrorKind::input) throw;
      if (end.unreadable++ == 0) end.firstReason = error.what();
    }
    index.tellSometimes();
  }
  allowHeaders(paths.size(), 0);
  index.tell();
  return end;
}

}  // namespace isolux::readers
