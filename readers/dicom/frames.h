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

// Mosaics: one image holds the slices of a volume as tiles, row by row.
// These make the tiles of a mosaic the frames of `file`, whose image has been read as one frame. They throw
// Error{input} for a mosaic that does not say how many slices it has.
void splitSiemensMosaic(vtkDICOMMetaData* meta, DicomFile& file);
// United Imaging's ("VFRAME"), with a position for each tile. Layout: dcm2niix, nii_dicom.cpp.
void splitUnitedMosaic(vtkDICOMMetaData* meta, DicomFile& file);

}  // namespace isolux::readers
