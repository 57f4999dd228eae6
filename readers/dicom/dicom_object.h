// What kind of object a DICOM file holds, where that is no scan.
#pragma once

#include <string>
#include <string_view>

namespace isolux::readers {

struct DicomObject {
  std::string notAScan;  // why it is not read, e.g. "is a segmentation (SEG), not a scan"; "": it is
  std::string remark;    // what to know of one that is read, e.g. that it is a screenshot; "": nothing
  bool hasUnit = true;   // false: its values have none, whatever its modality says
};
DicomObject dicomObject(std::string_view sopClass, std::string_view modality);

// Why a transfer syntax is not read, with what converts it; "": vtk-dicom or GDCM may read it.
std::string transferSyntaxProblem(std::string_view uid);

}  // namespace isolux::readers
