// Reads the segments that 3D Slicer lists in the header of a .seg.nrrd file, as key/value pairs:
//
//   Segment0_Name:=liver
//   Segment0_Color:=0.87 0.6 0.5        sRGB, each in [0, 1]
//   Segment0_LabelValue:=1              1 if not given
//   Segment0_Layer:=0                   the component that holds it; the segment's number if not given
//
// Source: 3D Slicer, "Segmentations", "Segmentation file (.seg.nrrd)" of its user guide.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "volume/labels/label_table.h"
#include "volume/read/input/text.h"

namespace isolux::volume {

using NrrdKeys = std::map<std::string_view, HeaderField>;  // the "key:=value" lines by key

// Returns nullopt without segments, and of fractional ones, whose values are shares. `layers`: components of
// the volume. Throws base::Error{input} for a layer that does not exist and a label value that is no number.
std::optional<LabelTable> segmentsOf(const NrrdKeys& keys, std::int64_t layers, const std::string& file,
                                     std::vector<std::string>& warnings);

}  // namespace isolux::volume
