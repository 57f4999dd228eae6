// Headerless volumes: the description comes from the user ("256x256x128 int16 big spacing 1,1,2 header 512").
//
// Read by our own decoder: nothing but a size check and a byte swap is needed, and VTK's raw reader checks
// neither.
#pragma once

#include "volume/read/input/image_header.h"

namespace isolux::volume {

// For a file of any size; checks dims and spacing, not the file.
ImageHeader headerOfRaw(const RawDescription& description, const std::string& file);

}  // namespace isolux::volume
