// A lock on a file (flock): it falls with the process that holds it, however that ends.
#pragma once

#include <filesystem>
#include <memory>

namespace isolux::app {

// Held until the last copy is destroyed.
using FileLock = std::shared_ptr<const int>;
// Null when another process, or another FileLock of this one, has it, or the file cannot be made.
FileLock tryLock(const std::filesystem::path& file);

}  // namespace isolux::app
