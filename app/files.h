// Files of the program: read whole, written beside their name and renamed when complete.
//
// Errors: scene::Error{input} naming the file and the system's reason. All functions may be called from any
// thread.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace isolux::app {

// A file (or folder) under construction. Until commit() it lives beside its name as ".NAME.PID-N.part"; the
// destructor removes it, so a failure leaves the old file, or none.
class PendingFile {
 public:
  // Throws when the folder does not exist or the target is something other than a regular file.
  explicit PendingFile(std::filesystem::path target);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  const std::filesystem::path& path() const { return path_; }      // write here
  const std::filesystem::path& target() const { return target_; }  // the name it will have
  void commit();

 private:
  std::filesystem::path target_, path_;
};

// Removes every PendingFile that is not committed: for the way out after an interrupt.
void removePendingFiles() noexcept;

void writeTextFile(const std::filesystem::path& file, std::string_view text);
// Throws also when the file is longer than `longest` bytes.
std::string readTextFile(const std::filesystem::path& file, std::size_t longest);

// The first `longest` bytes, fewer when the file is shorter, none when it cannot be read.
std::string readBeginning(const std::filesystem::path& file, std::size_t longest);

}  // namespace isolux::app
