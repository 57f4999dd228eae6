#include "volume/read/process/dicom_index.h"

#include <algorithm>

#include "base/error.h"
#include "volume/read/process/foreign.h"

namespace isolux::volume {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t mostSkipped = 16;  // files that end the reader

DicomIndexEnd indexOnce(const fs::path& program, const Request& request,
                        const std::function<void(DicomSeries)>& found, base::Progress& progress) {
  ReaderProcess reader(program, request, progress);
  for (;;) {
    const auto message = reader.expectEither(MessageKind::series, MessageKind::index);
    if (message.kind == MessageKind::index) return decodeIndexEnd(message.body);
    found(decodeSeries(message.body));
  }
}

bool liesBelow(const fs::path& file, const fs::path& folder) {
  const fs::path relative = file.lexically_normal().lexically_relative(folder.lexically_normal());
  return !relative.empty() && *relative.begin() != ".." && relative != ".";
}

}  // namespace

DicomIndexEnd indexDicom(const fs::path& folder, const std::function<void(DicomSeries)>& found,
                         base::Progress& progress, const fs::path& program) {
  progress.report(0.0, "looking for series");
  Request request{.task = Task::index, .path = folder.string()};
  std::string firstReason;
  for (;;) {
    try {
      DicomIndexEnd end = indexOnce(program, request, found, progress);
      end.unreadable += static_cast<std::int64_t>(request.skip.size());
      if (!firstReason.empty()) end.firstReason = firstReason;
      return end;
    } catch (const base::Error& error) {
      const bool ofAFile = error.kind() == base::ErrorKind::input || error.kind() == base::ErrorKind::memory;
      const bool again = std::ranges::find(request.skip, error.file()) != request.skip.end();
      if (!ofAFile || again || request.skip.size() >= mostSkipped || !liesBelow(error.file(), folder)) throw;
      if (firstReason.empty()) firstReason = error.what();
      request.skip.push_back(error.file());
    }
  }
}

DecodedImage previewDicom(const fs::path& file, int frame, base::Progress& progress) {
  Request request{.task = Task::preview, .path = file.string()};
  request.options.timeStep = frame;
  ReaderProcess reader(readerProgram("isolux-reader-dicom"), request, progress);
  return receivedImage(reader);
}

}  // namespace isolux::volume
