// The series of a DICOM folder, listed on a background thread; and a small picture of one slice.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/task.h"
#include "volume/read/process/dicom_index.h"

namespace isolux::app {

// Puts a series in the place of the one with the same UID, or at the end.
void addSeries(std::vector<volume::DicomSeries>& all, volume::DicomSeries series);

// Its news: the series that were found, or became better known; its value: what was looked at.
using IndexTask = base::Task<volume::DicomIndexEnd, std::vector<volume::DicomSeries>>;
std::unique_ptr<IndexTask> indexTask(const std::string& folder);

// Linear RGB.
using PreviewTask = base::Task<volume::DecodedImage>;
std::unique_ptr<PreviewTask> previewTask(const std::string& file, int frame);

}  // namespace isolux::app
