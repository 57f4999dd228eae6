// Files of the program: read whole, and written whole (base/pending_file.h).
//
// Errors: base::Error{input} naming the file and the system's reason. All functions may be called from any
// thread.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/pending_file.h"

namespace isolux::app {

using base::OutputLock;
using base::PendingFile;
using base::removePendingFiles;

// A folder for results. What had to be made of it goes away again if nothing comes to lie in it.
class MadeFolder {
 public:
  explicit MadeFolder(std::filesystem::path folder);  // with its parents; throws where that cannot be
  ~MadeFolder();
  MadeFolder(const MadeFolder&) = delete;
  MadeFolder& operator=(const MadeFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  void removeMade() const noexcept;

  std::filesystem::path path_;
  std::vector<std::filesystem::path> made_;  // the innermost first
};

void writeTextFile(const std::filesystem::path& file, std::string_view text);
// Throws also when the file is longer than `longest` bytes.
std::string readTextFile(const std::filesystem::path& file, std::size_t longest);

// The first `longest` bytes, fewer when the file is shorter, none when it cannot be read.
std::string readBeginning(const std::filesystem::path& file, std::size_t longest);

}  // namespace isolux::app
