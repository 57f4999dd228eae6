#include "app/files/file_names.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "base/words.h"

namespace isolux::app {

namespace fs = std::filesystem;

namespace {

// Formats that stand behind that of what they compress.
bool isCompression(const std::string& extension) {
  constexpr std::array<std::string_view, 5> known{".gz", ".bz2", ".xz", ".zst", ".z"};
  return std::ranges::find(known, extension) != known.end();
}

}  // namespace

std::string plainName(const std::string& path) {
  constexpr std::string_view phantom = "phantom:";
  if (path.starts_with(phantom)) {
    const std::string name = path.substr(phantom.size());
    return name.substr(0, name.find(':'));
  }
  fs::path file = fs::path(path).lexically_normal();
  if (file.filename().empty()) file = file.parent_path();  // "folder/"
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) return file.filename().string();
  fs::path name = file.filename();
  if (isCompression(base::lowerCase(name.extension().string()))) name = name.stem();
  return name.stem().string();
}

}  // namespace isolux::app
