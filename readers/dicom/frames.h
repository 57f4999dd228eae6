// Where the frames of a file lie, and what tells apart those at one place.
#pragma once

#include <vector>

class vtkDICOMMetaData;

namespace isolux::readers {

struct DicomFile;
struct DicomFrame;

// Sets where the frame lies, if both are stated (3 and 6 numbers).
void setPosition(const std::vector<double>& position, const std::vector<double>& orientation,
                 DicomFrame& frame);

// Fills `file.frames`, `isCine` and `pixelAspect` for so many frames.
void readFrames(vtkDICOMMetaData* meta, int count, DicomFile& file);

}  // namespace isolux::readers
