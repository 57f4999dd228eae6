// VTK XML image data (.vti): inline or appended, text, base64 or raw, with any of VTK's compressors.
//
// Read by VTK's own reader (readers/vtk), which gets this format right (also the Direction matrix), but only
// after our own check of the header, here, has passed: extents, array size, and the block table of compressed
// data against the size of the file. VTK alone allocates whatever the extents claim.
//
// One piece that is the whole extent. The array named by Scalars=, else the first, of the point data (else
// of the cell data). Throws base::Error{input} naming element and attribute.
#pragma once

#include <optional>

#include "volume/read/input/bytes.h"
#include "volume/read/input/image_header.h"

namespace isolux::volume {

struct VtiHeader {
  ImageHeader image;             // payload unused
  std::string array;             // its name
  bool cells = false;            // in the cell data
  std::optional<Payload> plain;  // where its voxels are bytes of the file
};

// Everything that is checked before VTK sees the file.
VtiHeader parseVtiHeader(const Bytes& bytes, const ReadOptions& options);

}  // namespace isolux::volume
