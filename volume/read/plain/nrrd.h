// NRRD 1 to 6, attached (.nrrd) and detached (.nhdr + data): raw, gzip and text encodings.
//
// Read by our own parser: VTK 9.1's reader ignores the space directions, fails on text encoding and on
// "byte skip: -1", reads a 2x2x2 file as 2x2x1 and crashes on absurd sizes.
//
// RAS and LAS spaces are converted to LPS, lengths to mm by "space units" or "units". One axis that is not
// spatial may come first (components) or last (time steps, or components when its kind says vector), or both.
// Throws base::Error{input} with the line.
#pragma once

#include <string_view>

#include "volume/read/input/image_header.h"

namespace isolux::volume {

constexpr std::size_t kLongestNrrdHeader = std::size_t{1} << 20;  // bytes

// `text` starts at the beginning of the file and may run on into the voxels.
ImageHeader parseNrrdHeader(std::string_view text, const std::string& file);

}  // namespace isolux::volume
