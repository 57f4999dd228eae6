// isolux-reader-dicom: what vtk-dicom and GDCM parse.
#include <vtkDICOMConfig.h>

#include "readers/dicom/dicom.h"
#include "readers/serve.h"

int main() {
  using namespace isolux;
  return readers::serve({.volume = readers::decodeDicom,
                         .index = readers::indexDicomFolder,
                         .preview = readers::previewDicomFile,
                         .versions = [] { return std::string("vtk-dicom ") + DICOM_SHORT_VERSION; }});
}
