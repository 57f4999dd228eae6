// Legacy VTK files (.vtk) with a STRUCTURED_POINTS dataset, text or binary.
//
// Read by our own parser: a check that is strict enough to trust VTK's reader with the file has to find the
// array and its size anyway, VTK's reader cannot be stopped within an array, and it prints to stderr and
// goes on when numbers are missing. Binary data are big endian by definition. The first array of the point
// data (else of the cell data) is read. Throws base::Error{input} with the line.
#pragma once

#include "volume/read/input/bytes.h"
#include "volume/read/input/image_header.h"

namespace isolux::volume {

ImageHeader parseVtkLegacyHeader(const Bytes& bytes);

}  // namespace isolux::volume
