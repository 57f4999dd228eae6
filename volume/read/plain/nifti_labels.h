// Reads tables of labels from the extensions of a NIfTI header: XML as Connectome Workbench writes it, and
// TotalSegmentator after it:
//
//   <LabelTable><Label Key="1" Red="0.4" Green="0.2" Blue="0.1" Alpha="1"><![CDATA[spleen]]></Label>...
//
// Colours are sRGB, each in [0, 1]. Other extensions are passed over, also damaged ones: they state nothing.
#pragma once

#include <optional>
#include <string_view>

#include "volume/labels/label_table.h"

namespace isolux::volume {

// `extensions`: the bytes from the extension flag (4 bytes behind the header) to the voxels.
std::optional<LabelTable> labelsInExtensions(std::string_view extensions, bool bigEndian);

}  // namespace isolux::volume
