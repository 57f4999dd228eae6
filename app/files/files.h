// Reads whole files, and writes them atomically (base/pending_file.h).
//
// Throws base::Error{input} naming the file and the system's reason. All functions are safe from any thread.
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

// A folder for results. Folders that it created are removed if nothing is written to them.
class MadeFolder {
 public:
  explicit MadeFolder(std::filesystem::path folder);  // creates it with its parents; throws if that fails
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
// Returns the contents. Throws also if the file is longer than `longest` bytes.
std::string readTextFile(const std::filesystem::path& file, std::size_t longest);

// Returns the first `longest` bytes, fewer if the file is shorter, none if it cannot be read.
std::string readBeginning(const std::filesystem::path& file, std::size_t longest);

}  // namespace isolux::app
