// Siemens mosaics: one image holds the slices of a volume as tiles.
#pragma once

class vtkDICOMMetaData;

namespace isolux::readers {

struct DicomFile;

// Makes the tiles of a mosaic the frames of `file`, whose image has been read as one frame. Throws
// Error{input} for a mosaic that does not say how many slices it has.
void splitMosaic(vtkDICOMMetaData* meta, DicomFile& file);

}  // namespace isolux::readers
