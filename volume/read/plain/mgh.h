// Parses FreeSurfer's volumes: .mgh, and .mgz, the same gzipped.
//
// Big endian: a header of 284 bytes, then the voxels (x fastest, then y, z, frames), then statements of the
// scanner, which are passed over. Frames are time steps. The affine is by FreeSurfer's definition
// M = Mdc diag(delta), with c_ras at voxel dims / 2 (not (dims - 1) / 2); RAS+ is converted to LPS. Where
// goodRASFlag is 0, FreeSurfer's default (coronal, 1 mm) holds, with a warning. Source: FreeSurfer's wiki,
// "FsTutorial/MghFormat". Throws base::Error{input} with the field's name.
#pragma once

#include <string>
#include <string_view>

#include "volume/read/input/image_header.h"

namespace isolux::volume {

constexpr std::size_t kMghHeaderBytes = 284;

// `head`: the first bytes of the file, inflated.
bool looksLikeMgh(std::string_view head);

// `head`: as looksLikeMgh(); `packed`: the file is a gzip stream of it.
ImageHeader parseMghHeader(std::string_view head, bool packed, const std::string& file);

}  // namespace isolux::volume
