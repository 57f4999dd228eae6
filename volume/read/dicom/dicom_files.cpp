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

constexpr std::size_t mostFiles = 100000;

// Regular files of the folder and its direct subfolders, sorted; `use` returns false to stop.
void visitFiles(const fs::path& folder, const std::function<bool(const fs::path&)>& use) {
  std::error_code error;
  std::vector<fs::path> files, folders;
  for (const auto& entry :
       fs::directory_iterator(folder, fs::directory_options::skip_permission_denied, error)) {
    std::error_code ignored;
    if (entry.is_regular_file(ignored)) files.push_back(entry.path());
    if (entry.is_directory(ignored) && !entry.is_symlink(ignored)) folders.push_back(entry.path());
    if (files.size() > mostFiles) throwInput(folder.string(), "", "the folder has more than 100000 files");
  }
  if (error) throwInput(folder.string(), "", "cannot be listed: " + error.message());
  std::sort(folders.begin(), folders.end());
  for (const fs::path& sub : folders)
    for (const auto& entry :
         fs::directory_iterator(sub, fs::directory_options::skip_permission_denied, error)) {
      std::error_code ignored;
      if (entry.is_regular_file(ignored)) files.push_back(entry.path());
      if (files.size() > mostFiles) throwInput(folder.string(), "", "the folder has more than 100000 files");
    }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files)
    if (!use(file)) return;
}

// Old files lack the mark and begin with their first element at once, of group 2 or 8.
bool beginsWithElement(std::string_view head) {
  if (head.size() < 8) return false;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(head[i]); };
  const bool little = (byte(0) == 2 || byte(0) == 8) && byte(1) == 0;
  const bool big = byte(0) == 0 && (byte(1) == 2 || byte(1) == 8);
  return little || big;
}

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

}  // namespace

bool looksLikeDicom(std::string_view head) {
  return head.size() >= 132 && head.substr(128, 4) == "DICM";
}

bool hasDicomFiles(const fs::path& folder) {
  bool found = false;
  visitFiles(folder, [&](const fs::path& file) { return !(found = isDicomFile(file)); });
  return found;
}

std::vector<fs::path> dicomFilesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  visitFiles(folder, [&](const fs::path& file) {
    if (isDicomFile(file)) files.push_back(file);
    return true;
  });
  return files;
}

}  // namespace isolux::volume
