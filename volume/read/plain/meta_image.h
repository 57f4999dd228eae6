// MetaImage (.mha, .mhd + data): "Key = Value" lines, then or beside them the voxels.
//
// Read by our own parser: VTK 9.1's reader ignores the direction matrix and accepts broken headers (negative
// extents crash it); ITK's would be a large dependency for a header of twenty keys.
//
// Geometry is LPS, as ITK reads it: row i of TransformMatrix is the direction of axis i; lengths are mm, or
// what DistanceUnits says. Throws base::Error{input} with the line and key.
#pragma once

#include <string_view>

#include "volume/read/input/image_header.h"

namespace isolux::volume {

// Sequences of tracked ultrasound have several lines for each frame.
constexpr std::size_t kLongestMetaImageHeader = std::size_t{16} << 20;  // bytes

// `text` starts at the beginning of the file and may run on into the voxels.
ImageHeader parseMetaImageHeader(std::string_view text, const std::string& file);

bool looksLikeMetaImage(std::string_view text);

}  // namespace isolux::volume
