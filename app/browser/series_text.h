// What is shown of a DICOM series, and which one a search finds. No errors; any thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "volume/read/dicom/dicom_series.h"

namespace isolux::app {

// "DOE^JANE^A" is "DOE, JANE A"; other texts stay as they are.
std::string personText(const std::string& name);
// "20240131" is "2024-01-31"; other texts stay as they are.
std::string dateText(const std::string& date);
// "512 × 512"; "0.75 × 0.75 × 2 mm", "" where nothing is known.
std::string sizeText(const volume::DicomSeries& series);
std::string spacingText(const volume::DicomSeries& series);
// "120", "4 × 30" of time steps.
std::string slicesText(const volume::DicomSeries& series);
// Its description, else its number, else "series".
std::string titleOf(const volume::DicomSeries& series);
// In a word or two each: "gantry tilt", "missing slices", "uneven spacing", "mixed slices", "resampled",
// "cannot be opened"; what is none of these stays whole.
std::vector<std::string> shortWarnings(const volume::DicomSeries& series);

// Each word of `search` occurs in what is shown of the series, whatever the case; with `hidden` the patient
// is not looked at. An empty search finds all.
bool matches(const volume::DicomSeries& series, std::string_view search, bool hidden);

}  // namespace isolux::app
