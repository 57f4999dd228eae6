// Reads DICOM segmentations (SEG): one file, its frames unpacked and put where they lie.
//
// BINARY: a frame is a mask of one segment, 1 bit a pixel; frames follow each other without padding to bytes
// (PS3.5 8.1.1). Voxels are segment numbers, 0 outside; segments that overlap lie in several components, the
// layers, each segment in the first layer in which its voxels are free. LABELMAP: pixels are segment numbers.
// FRACTIONAL: a component for each segment, values from 0 to 1 (stored / MaximumFractionalValue), no labels.
// Missing frames are empty. Slices are as far apart as SpacingBetweenSlices says, else as the positions
// allow; no frame may lie between two slices or more than half a pixel beside their line. Refused:
// segmentations of slides (tiles), compressed BINARY ones. Colours: RecommendedDisplayCIELabValue (PS3.3
// C.10.7.1.1).
#pragma once

#include <string_view>

#include "base/progress.h"
#include "volume/read/process/reader_messages.h"

namespace isolux::readers {

struct DicomFile;

// Says whether objects of this class are read here.
bool isSegmentationClass(std::string_view sopClass);

// `file`: its header. Throws base::Error: input, memory, usage (no such component), interrupted.
volume::DecodedVolume decodeSegmentation(const DicomFile& file, const volume::ReadOptions& options,
                                         base::Progress& progress);

}  // namespace isolux::readers
