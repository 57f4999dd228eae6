// A lock on a file (flock): it falls with the process that holds it, however that ends.
#pragma once

#include <filesystem>
#include <optional>

namespace isolux::app {

// Held until it is destroyed. Movable.
class FileLock {
 public:
  // Nothing when another process, or another FileLock of this one, has it, or the file cannot be made.
  static std::optional<FileLock> tryLock(const std::filesystem::path& file);
  ~FileLock();
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;

 private:
  explicit FileLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_;
};

}  // namespace isolux::app
