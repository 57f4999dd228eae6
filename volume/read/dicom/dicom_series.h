// What the headers of a DICOM series say: for lists to choose from, before anything is decoded.
//
// Texts are as in the files (UTF-8): dates YYYYMMDD, names "Family^Given". Whoever shows or stores them asks
// first whether the patient is to be named (app/documents/anonymous.h).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "volume/read/input/patient.h"

namespace isolux::volume {

struct DicomStatements {
  Patient patient;
  std::string study, studyDescription, studyDate;  // `study`: its UID
  std::string series, description, date;           // `series`: its UID, for Source::series
  std::string modality, kernel, number;
};

struct DicomSeries : DicomStatements {
  std::string folder;  // absolute; all its files are in it or below: for Source::path
  std::int64_t columns = 0, rows = 0, slices = 0, timeSteps = 1;  // slices: as found, before resampling
  glm::dvec3 spacingMm{0.0};          // of columns, rows, slices; 0 where not known
  std::string problem;                // why it cannot be opened; "": it can
  std::vector<std::string> warnings;  // what opening it will say: tilt, gaps, slices that do not belong
  std::string middleFile;             // the slice in the middle, and its frame: for a small picture
  int middleFrame = 0;
};

// What was looked at on the way.
struct DicomIndexEnd {
  std::int64_t files = 0, dicomFiles = 0, unreadable = 0;
  std::string firstReason;  // why the first unreadable one is
};

}  // namespace isolux::volume
