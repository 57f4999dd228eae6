// isolux-reader-dicom: what vtk-dicom and GDCM parse.
#include <vtkDICOMConfig.h>

#include "readers/dicom/dicom.h"
#include "readers/serve.h"

int main() {
  using namespace isolux;
  readers::Abilities abilities;
  abilities.volume = readers::decodeDicom;
  abilities.index = readers::indexDicomFolder;
  abilities.preview = readers::previewDicomFile;
  abilities.versions = [] { return std::string("vtk-dicom ") + DICOM_SHORT_VERSION; };
  return readers::serve(abilities);
}
