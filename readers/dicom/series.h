// What the slices of one DICOM series make together, by their headers alone: the same for lists of series and
// for opening one.
#pragma once

#include <string>
#include <vector>

#include "readers/dicom/dicom.h"
#include "volume/read/dicom/slice_stack.h"

namespace isolux::readers {

// A frame of the series, by file and number. The files must outlive it.
struct DicomSource {
  const DicomFile* file = nullptr;
  std::size_t fileIndex = 0, frameIndex = 0;
  std::size_t filePixel = 0;  // the first of the file among those of all files
  const DicomFrame& frame() const { return file->frames[frameIndex]; }
};

// Without objects that are no scans. Throws Error{input} where nothing else is there.
std::vector<DicomFile> onlyScans(std::vector<DicomFile> files);

// The largest set of slices that fit together, each once; whole files, so that one decoder run reads them. At
// least one.
std::vector<DicomFile> keepMajority(std::vector<DicomFile> files, std::vector<std::string>& warnings);

std::vector<DicomSource> sourcesOf(const std::vector<DicomFile>& files);

// The grid they lie on. `folder` is for messages. Throws Error{input} where there is none.
volume::SliceStack stackOf(const std::vector<DicomSource>& sources, const std::string& folder,
                           std::vector<std::string>& warnings);

}  // namespace isolux::readers
