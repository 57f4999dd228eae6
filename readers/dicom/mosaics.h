// Mosaics: one image holds the slices of a volume as tiles, row by row.
#pragma once

class vtkDICOMMetaData;

namespace isolux::readers {

struct DicomFile;

// These make the tiles of a mosaic the frames of `file`, whose image has been read as one frame. They throw
// Error{input} for a mosaic that does not say how many slices it has.
void splitSiemensMosaic(vtkDICOMMetaData* meta, DicomFile& file);
// United Imaging's ("VFRAME"), with a position for each tile. Layout: dcm2niix, nii_dicom.cpp.
void splitUnitedMosaic(vtkDICOMMetaData* meta, DicomFile& file);

}  // namespace isolux::readers
