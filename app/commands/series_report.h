// What `isolux info --series` prints: the DICOM series of a folder, by their headers.
#pragma once

#include <iosfwd>
#include <string>

#include "base/progress.h"

namespace isolux::app {

// `hidden`: patients are "anonymous", with a number. Throws base::Error{input} where there is no series.
void printSeries(const std::string& folder, bool json, bool hidden, base::Progress& progress,
                 std::ostream& out);

}  // namespace isolux::app
