// Lists the DICOM series of a folder or disc by their headers, and makes small pictures of slices; a reader
// parses (reader_process.h).
#pragma once

#include <filesystem>
#include <functional>

#include "base/progress.h"
#include "volume/read/dicom/dicom_series.h"
#include "volume/read/process/reader_messages.h"

namespace isolux::volume {

// Looks at every file of `folder` and its subfolders, to a depth of 8. `found` is called on this thread with
// each series as far as it is known, again when more of it is known: the newest of the same UID holds. Files
// that cannot be read are counted; one that ends the reader is left out, and the others are looked at again.
// No DICOM at all is no error. Throws base::Error (input: the folder cannot be listed; interrupted).
DicomIndexEnd indexDicom(const std::filesystem::path& folder, const std::function<void(DicomSeries)>& found,
                         base::Progress& progress);

// One frame as a screen shows it by the file's window, or else by what its values are; at most 160 pixels
// wide and high, square ones. Throws base::Error.
DecodedImage previewDicom(const std::filesystem::path& file, int frame, base::Progress& progress);

// The first with any program in the reader's place.
DicomIndexEnd indexDicomBy(const std::filesystem::path& program, const std::filesystem::path& folder,
                           const std::function<void(DicomSeries)>& found, base::Progress& progress,
                           double patienceSeconds = 30.0);

}  // namespace isolux::volume
