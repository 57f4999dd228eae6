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

// A channel of size.x * size.y values, row 0 at the top: every `stride`th from `first`.
struct ExrChannel {
  std::string name;
  const float* first;
  std::size_t stride;
};
// Float32, compressed without loss (zip). `attributes`: names and texts for the header.
void writeExrFile(glm::ivec2 size, const std::vector<ExrChannel>& channels,
                  const std::vector<std::pair<std::string, std::string>>& attributes,
                  const std::filesystem::path& file);

}  // namespace isolux::app
