#include "readers/dicom/dicom_object.h"

namespace isolux::readers {

namespace {

struct SopClass {
  std::string_view uid;  // of the class, or what the UIDs of a family begin with
  std::string_view name;
  bool isRead = false;
};
// The first that fits holds. The image classes that are not listed are scans.
constexpr std::string_view storage = "1.2.840.10008.5.1.4.1.1.";
constexpr SopClass classes[] = {
    {"66.1", "a spatial registration (REG)"},
    {"66.2", "a list of spatial fiducials"},
    {"66.3", "a deformable registration (REG)"},
    {"66.4", "a segmentation (SEG)"},
    {"66.5", "a surface segmentation"},
    {"66.6", "a set of tractography results"},
    {"66.7", "a label map segmentation (SEG)"},
    {"66.8", "a height map segmentation (SEG)"},
    {"66", "raw data"},
    {"67", "a real world value mapping"},
    {"68", "a surface scan"},
    {"481.1", "a radiotherapy image (a projection)", true},
    {"481.2", ""},  // a dose distribution: a scan
    {"481.3", "a set of contours (RTSTRUCT)"},
    {"481", "a radiotherapy plan or record"},
    {"88", "a structured report (SR)"},
    {"11", "a presentation state (PR)"},
    {"77.1.6", "a whole-slide image (SM)"},
    {"77.1.5.4", ""},  // an optical coherence tomogram: a scan
    {"77", "a photograph or visible-light image", true},
    {"78", "an eye measurement"},
    {"79", "an eye measurement"},
    {"9", "a waveform"},
    {"104", "an encapsulated document or mesh"},
    {"4.2", "an MR spectroscopy"},
    {"7", "a secondary capture (a screenshot or a converted image)", true},
    {"1", "a radiograph (a projection)", true},
    {"12", "a radiograph or angiogram (a projection)", true},
};

// What a modality says where the class does not.
constexpr SopClass modalities[] = {
    {"SEG", "a segmentation (SEG)"},        {"RTSTRUCT", "a set of contours (RTSTRUCT)"},
    {"RTPLAN", "a radiotherapy plan"},      {"RTRECORD", "a radiotherapy record"},
    {"SR", "a structured report (SR)"},     {"KO", "a list of key objects (KO)"},
    {"PR", "a presentation state (PR)"},    {"REG", "a spatial registration (REG)"},
    {"FID", "a list of spatial fiducials"}, {"SM", "a whole-slide image (SM)"},
    {"DOC", "an encapsulated document"},    {"M3D", "an encapsulated mesh"},
    {"RWV", "a real world value mapping"},  {"ECG", "a waveform"},
};

bool belongsTo(std::string_view uid, std::string_view family) {
  return uid.starts_with(family) && (uid.size() == family.size() || uid[family.size()] == '.');
}

DicomObject described(const SopClass& sopClass) {
  const std::string name(sopClass.name);
  if (!sopClass.isRead) return {"is " + name + ", not a scan", "", false};
  return {"", "the image is " + name + ": its values and lengths may differ from those of a scan", false};
}

}  // namespace

DicomObject dicomObject(std::string_view sopClass, std::string_view modality) {
  if (sopClass == "1.2.840.10008.1.3.10")
    return {"is the index of a disc (DICOMDIR); open its folder", "", false};
  for (const SopClass& one : modalities)
    if (modality == one.uid) return described(one);
  if (!sopClass.starts_with(storage)) return {};
  for (const SopClass& one : classes)
    if (belongsTo(sopClass.substr(storage.size()), one.uid))
      return one.name.empty() ? DicomObject() : described(one);
  return {};
}

std::string transferSyntaxProblem(std::string_view uid) {
  constexpr std::string_view prefix = "1.2.840.10008.1.2.";
  struct Syntax {
    std::string_view uid, name, converter;
  };
  constexpr Syntax syntaxes[] = {
      // The first that fits holds, also as the beginning of a family.
      {"1.99", "deflated", "gdcmconv --raw or dcmconv +te"},
      {"4.94", "JPIP: its pixels are elsewhere", ""},
      {"4.95", "JPIP: its pixels are elsewhere", ""},
      {"4.204", "JPIP: its pixels are elsewhere", ""},
      {"4.205", "JPIP: its pixels are elsewhere", ""},
      {"4.107", "HEVC video", "ffmpeg"},
      {"4.108", "HEVC video", "ffmpeg"},
      {"4.10", "MPEG video", "ffmpeg"},
      {"4.11", "JPEG XL", "dicom-transcode (dicom-rs)"},
      {"4.20", "HTJ2K", "pydicom 3 with pylibjpeg-openjpeg"},
      {"8.1", "deflated frames", "pydicom 3"},
  };
  if (!uid.starts_with(prefix)) return {};
  for (const Syntax& one : syntaxes)
    if (uid.substr(prefix.size()).starts_with(one.uid))
      return "the transfer syntax " + std::string(uid) + " (" + std::string(one.name) + ") is not read" +
             (one.converter.empty() ? std::string() : "; convert it with " + std::string(one.converter));
  return {};
}

}  // namespace isolux::readers
