// One slice of a headerless file as a grey picture, read straight from the file: for the preview.
#pragma once

#include <optional>

#include <QImage>
#include <QString>

#include "volume/read/input/read_options.h"

namespace isolux::ui {

// Slice z of `file`, at most `longestSide` pixels wide and high (larger slices are thinned out), brightness
// from the 1st to the 99th percentile of the slice; missing voxels are shown dark red. Empty when the slice
// lies outside the file. Reads no more than the rows it shows.
std::optional<QImage> rawSlice(const QString& file, const volume::RawDescription& description, int z,
                               int longestSide);

}  // namespace isolux::ui
