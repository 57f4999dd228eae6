// Formats that are known by name or content but not read: each with a program that converts it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "volume/read/input/bytes.h"

namespace isolux::volume {

// What the file is and what helps, one clause; nothing where it may be raw voxels. For files of which
// formatOf() knows nothing. Any thread.
std::optional<std::string> knownButNotRead(const Bytes& bytes, const std::filesystem::path& path);

// As knownButNotRead(), of a folder by its files.
std::optional<std::string> knownButNotReadIn(const std::filesystem::path& folder);

}  // namespace isolux::volume
