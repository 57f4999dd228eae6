// The pixels of DICOM files, by vtk-dicom, which knows the transfer syntaxes (through GDCM).
#pragma once

#include <string>
#include <vector>

#include <vtkSmartPointer.h>

#include "base/progress.h"
#include "readers/dicom/dicom.h"

class vtkDataArray;

namespace isolux::readers {

// Returns the pixels of all files, in their order. RGB of JPEG is what the file says that it
// is. `name`: of all of them, for messages. Throws base::Error: input for pixels that cannot be decoded, with
// the file; interrupted.
vtkSmartPointer<vtkDataArray> decodeFiles(const std::vector<DicomFile>& files, const std::string& name,
                                          const VtkMessages& messages, base::Progress& progress);

}  // namespace isolux::readers
