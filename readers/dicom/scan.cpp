// The DICOM files of a folder.
#include <algorithm>

#include "base/error.h"
#include "readers/dicom/dicom.h"
#include "readers/limits.h"
#include "readers/serve.h"
#include "readers/vtk_messages.h"
#include "volume/read/dicom/dicom_files.h"
#include "volume/read/input/bytes.h"

namespace isolux::readers {

using namespace volume;
namespace fs = std::filesystem;
using base::throwInput;

DicomFile readWholeHeader(const fs::path& path) {
  const VtkMessages messages;
  DicomFile file = readHeader(path);
  if (!messages.errors().empty()) throwInput(path.string(), "header", messages.errors().front());
  return file;
}

std::vector<DicomFile> scanDicomFolder(const fs::path& folder, int depth, base::Progress& progress,
                                       std::vector<std::string>& warnings) {
  std::vector<DicomFile> files;
  int broken = 0, others = 0;
  std::string firstReason, firstOther;
  const std::vector<fs::path> paths = dicomFilesIn(folder, depth);
  std::uint64_t bytes = 0;
  for (const fs::path& path : paths) bytes += FileBytes(path).size();
  allowHeaders(paths.size(), bytes);
  for (const fs::path& path : paths) {
    progress.throwIfStopped();
    nowReading(path);
    try {
      DicomFile file = readWholeHeader(path);
      if (!file.notAScan.empty() && others++ == 0) firstOther = path.string() + " " + file.notAScan;
      if (!file.frames.empty()) files.push_back(std::move(file));
    } catch (const base::Error& error) {
      if (error.kind() != base::ErrorKind::input) throw;
      if (broken++ == 0) firstReason = error.what();
    }
  }
  const bool hasScans =
      std::any_of(files.begin(), files.end(), [](const DicomFile& file) { return file.notAScan.empty(); });
  if (!hasScans && broken > 0) throwInput(folder.string(), "", "no usable DICOM image; " + firstReason);
  if (!hasScans && others > 0) throwInput(folder.string(), "", "has no DICOM scan; " + firstOther);
  if (!hasScans) throwInput(folder.string(), "", "has no DICOM images");
  if (broken > 0)
    warnings.push_back(std::to_string(broken) +
                       " DICOM files are unreadable and left out; the first: " + firstReason);
  if (others > 0)
    warnings.push_back(std::to_string(others) +
                       " DICOM objects are not scans and are skipped; the first: " + firstOther);
  return files;
}

}  // namespace isolux::readers
