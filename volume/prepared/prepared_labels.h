// Lists the labels of a prepared volume, and rejects volumes whose values are none.
#pragma once

#include <memory>
#include <string>

#include "base/progress.h"
#include "volume/labels/label_blocks.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::volume {

// A mask of two values has labels; other values must look like labels (Volume::labels), or source.kind must
// say so. Throws Error{input} with `file` if they do not, if a value is not a whole number, or if there is no
// label but 0; Error: interrupted, memory.
std::shared_ptr<const LabelBlocks> labelBlocksOf(const PreparedVolume& prepared, const std::string& file,
                                                 base::Progress& progress);

}  // namespace isolux::volume
