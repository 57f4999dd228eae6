// Lists the DICOM series of a folder or disc by their headers, and makes small pictures of slices; a reader
// parses (reader_process.h).
#pragma once

#include <filesystem>
#include <functional>

#include "base/progress.h"
#include "volume/read/dicom/dicom_series.h"
#include "volume/read/process/reader_process.h"

namespace isolux::volume {

// Looks at every file of `folder` and its subfolders, to a depth of 8. `found` is called on this thread with
// each series as far as it is known, again when more of it is known: the newest of the same UID holds. Files
// that cannot be read are counted; one that ends the reader is left out, and the others are looked at again.
// No DICOM at all is no error. `program`: the reader. Throws base::Error (input: the folder cannot be listed;
// interrupted).
DicomIndexEnd indexDicom(const std::filesystem::path& folder, const std::function<void(DicomSeries)>& found,
                         base::Progress& progress,
                         const std::filesystem::path& program = readerProgram("isolux-reader-dicom"));

// One frame as a screen shows it by the file's window, or else by what its values are; at most 160 pixels
// wide and high, square ones. Throws base::Error.
DecodedImage previewDicom(const std::filesystem::path& file, int frame, base::Progress& progress);

}  // namespace isolux::volume
