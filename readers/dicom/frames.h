// Where the frames of a file lie, and what tells apart those at one place.
#pragma once

class vtkDICOMMetaData;

namespace isolux::readers {

struct DicomFile;

// Fills `file.frames`, `isCine` and `pixelAspect` for so many frames.
void readFrames(vtkDICOMMetaData* meta, int count, DicomFile& file);

}  // namespace isolux::readers
