#include "volume/read/dicom/dicom_files.h"

#include <algorithm>
#include <functional>

#include "base/error.h"
#include "volume/read/input/bytes.h"
#include "volume/read/input/text.h"

namespace isolux::volume {

namespace fs = std::filesystem;
using base::throwInput;

namespace {

constexpr std::size_t mostDicomFiles = 100000;

struct Visit {
  const std::function<bool(const fs::path&)>& use;  // false: enough
  std::size_t count = 0;
  bool goesOn = true;
};

// Folder by folder: those in the folder itself first, so that what is at the top is found without looking at
// all that is below. A subfolder that cannot be listed is passed by.
void visitFiles(const fs::path& folder, int depth, bool top, Visit& visit) {
  std::error_code error;
  std::vector<fs::path> files, folders;
  for (fs::directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error), end;
       !error && entry != end; entry.increment(error)) {
    std::error_code ignored;
    if (entry->is_regular_file(ignored)) files.push_back(entry->path());
    if (entry->is_directory(ignored) && !entry->is_symlink(ignored)) folders.push_back(entry->path());
    if (visit.count + files.size() > mostDicomFiles)
      throwInput(folder.string(), "", "the folder has more than 100000 files");
  }
  if (error && top) throwInput(folder.string(), "", "cannot be listed: " + error.message());
  visit.count += files.size();
  std::sort(files.begin(), files.end());
  std::sort(folders.begin(), folders.end());
  for (const fs::path& file : files)
    if (!(visit.goesOn = visit.use(file))) return;
  for (const fs::path& below : folders) {
    if (depth > 0) visitFiles(below, depth - 1, false, visit);
    if (!visit.goesOn) return;
  }
}

void visitFiles(const fs::path& folder, int depth, const std::function<bool(const fs::path&)>& use) {
  Visit visit{use};
  visitFiles(folder, depth, true, visit);
}

// Old files lack the mark and begin with their first element at once, of group 2 or 8.
bool beginsWithElement(std::string_view head) {
  if (head.size() < 8) return false;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(head[i]); };
  const bool little = (byte(0) == 2 || byte(0) == 8) && byte(1) == 0;
  const bool big = byte(0) == 0 && (byte(1) == 2 || byte(1) == 8);
  return little || big;
}

}  // namespace

bool isDicomFile(const fs::path& path) {
  if (path.filename() == "DICOMDIR") return false;  // an index, without pixels
  try {
    const std::string head = FileBytes(path).head(140);
    if (looksLikeDicom(head)) return head.find_first_not_of('\0', 132) != std::string::npos;
    return (sameIgnoringCase(path.extension().string(), ".dcm") && beginsWithElement(head));
  } catch (const base::Error&) {
    return false;
  }
}

bool looksLikeDicom(std::string_view head) {
  return head.size() >= 132 && head.substr(128, 4) == "DICM";
}

bool hasDicomFiles(const fs::path& folder) {
  bool found = false;
  visitFiles(folder, kDeepestDicomFolder, [&](const fs::path& file) { return !(found = isDicomFile(file)); });
  return found;
}

std::vector<fs::path> filesBelow(const fs::path& folder, int depth) {
  std::vector<fs::path> files;
  visitFiles(folder, depth, [&](const fs::path& file) {
    files.push_back(file);
    return true;
  });
  return files;
}

std::vector<fs::path> dicomFilesIn(const fs::path& folder, int depth) {
  std::vector<fs::path> files = filesBelow(folder, depth);
  std::erase_if(files, [](const fs::path& file) { return !isDicomFile(file); });
  return files;
}

}  // namespace isolux::volume
