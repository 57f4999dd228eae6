#include "volume/read/dicom/dicom_files.h"

#include <algorithm>
#include <cstdint>
#include <functional>

#include "base/error.h"
#include "volume/read/input/bytes.h"
#include "volume/read/input/text.h"

namespace isolux::volume {

namespace fs = std::filesystem;
using base::throwInput;

namespace {

constexpr std::size_t mostDicomFiles = 100000;

using Use = std::function<bool(const fs::path&)>;  // false: enough

// Folder by folder: those in the folder itself first, so that what is at the top is found without looking at
// all that is below. A subfolder that cannot be listed is passed by.
bool visitFiles(const fs::path& folder, int depth, const Use& use, std::size_t& count, bool top = true) {
  std::error_code error;
  std::vector<fs::path> files, folders;
  for (fs::directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error), end;
       !error && entry != end; entry.increment(error)) {
    std::error_code ignored;
    if (entry->is_regular_file(ignored)) files.push_back(entry->path());
    if (entry->is_directory(ignored) && !entry->is_symlink(ignored)) folders.push_back(entry->path());
    if (count + files.size() > mostDicomFiles)
      throwInput(folder.string(), "", "the folder has more than 100000 files");
  }
  if (error && top) throwInput(folder.string(), "", "cannot be listed: " + error.message());
  count += files.size();
  std::ranges::sort(files);
  std::ranges::sort(folders);
  return std::ranges::all_of(files, use) && std::ranges::all_of(folders, [&](const fs::path& below) {
           return depth == 0 || visitFiles(below, depth - 1, use, count, false);
         });
}

// Old files lack the mark and begin with their first element at once: this follows a few elements from the
// first of group 2 or 8, in ascending order: little endian with or without a VR, big endian with.
bool beginsWithElements(std::string_view head) {
  const bool isBig = head.size() > 1 && head[0] == 0;
  const auto number = [&](std::size_t at, std::size_t size) -> std::uint32_t {
    if (size == 2) return numberAt<std::uint16_t>(&head[at], isBig);
    return numberAt<std::uint32_t>(&head[at], isBig);
  };
  constexpr int enough = 3;
  std::uint32_t last = 0;
  std::size_t at = 0;
  for (int count = 0; count < enough; ++count) {
    if (at + 12 > head.size()) return false;
    const std::uint32_t group = number(at, 2), tag = group << 16 | number(at + 2, 2);
    if ((count == 0 && group != 2 && group != 8) || (count > 0 && tag <= last)) return false;
    last = tag;
    const std::string_view vr = head.substr(at + 4, 2);
    const bool isExplicit = std::ranges::all_of(vr, [](char c) { return c >= 'A' && c <= 'Z'; });
    if (isBig && !isExplicit) return false;
    const bool isLong = isExplicit && (vr == "OB" || vr == "OW" || vr == "SQ" || vr == "UN" || vr == "UT");
    const std::size_t value = isLong ? at + 12 : at + 8;
    at = value + (isExplicit && !isLong ? number(at + 6, 2) : number(value - 4, 4));
  }
  return true;
}

}  // namespace

bool isDicomIndex(const fs::path& path) {
  return sameIgnoringCase(path.filename().string(), "DICOMDIR") && !fs::is_directory(path);
}

bool isDicomFile(const fs::path& path) {
  if (isDicomIndex(path)) return false;
  try {
    const std::string head = FileBytes(path).head(kDicomHeadBytes);
    return looksLikeDicom(head) && head.find_first_not_of('\0', 132) != std::string::npos;
  } catch (const base::Error&) {
    return false;
  }
}

bool looksLikeDicom(std::string_view head) {
  return (head.size() >= 132 && head.substr(128, 4) == "DICM") || beginsWithElements(head);
}

bool hasDicomFiles(const fs::path& folder) {
  std::size_t count = 0;
  return !visitFiles(
      folder, kDeepestDicomFolder, [](const fs::path& file) { return !isDicomFile(file); }, count);
}

std::vector<fs::path> filesBelow(const fs::path& folder, int depth) {
  std::vector<fs::path> files;
  std::size_t count = 0;
  const Use keep = [&](const fs::path& file) { return files.push_back(file), true; };
  visitFiles(folder, depth, keep, count);
  return files;
}

std::vector<fs::path> dicomFilesIn(const fs::path& folder, int depth) {
  std::vector<fs::path> files = filesBelow(folder, depth);
  std::erase_if(files, [](const fs::path& file) { return !isDicomFile(file); });
  return files;
}

}  // namespace isolux::volume
