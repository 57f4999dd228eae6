// Reads what OME-Zarr states of label images: the colours and properties of its "image-label" (OME-NGFF 0.3
// to 0.5). A label's name is the property "name", else "class" or "label", where that is a text.
#pragma once

#include <optional>

#include "volume/labels/label_table.h"
#include "volume/read/zarr/json_fields.h"

namespace isolux::volume {

// `root`: the metadata of an image. Returns nullopt where it is not said to hold labels. Throws
// base::Error{input} naming the field.
std::optional<LabelTable> imageLabelsOf(const JsonField& root);

}  // namespace isolux::volume
