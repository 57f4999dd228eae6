// Reads the pictures that the program writes.
#pragma once

#include <filesystem>

#include "render/graph/frame.h"

namespace isolux::test {

// Reads 8-bit RGB or RGBA, at most 32768 x 32768; alpha is 255, and does not count, if the file has none.
// Throws base::Error{input}.
render::ColorImage readPng(const std::filesystem::path& file);

}  // namespace isolux::test
