// EXR files of float channels (OpenEXR), written beside their name and renamed when complete.
//
// Errors: base::Error{input} naming the file. Any thread.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

namespace isolux::app {

// Float32, compressed without loss (zip). `interleaved`: size.x * size.y pixels, row 0 at the top, each with
// one value per name. `attributes`: names and texts for the header.
void writeExrFile(glm::ivec2 size, const std::vector<std::string>& names,
                  const std::vector<float>& interleaved,
                  const std::vector<std::pair<std::string, std::string>>& attributes,
                  const std::filesystem::path& file);

}  // namespace isolux::app
