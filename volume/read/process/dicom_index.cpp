#include "volume/read/process/dicom_index.h"

#include <algorithm>

#include "base/error.h"
#include "volume/read/process/foreign.h"
#include "volume/read/process/reader_process.h"

namespace isolux::volume {

namespace fs = std::filesystem;

namespace {

constexpr const char* indexReader = "isolux-reader-dicom";
constexpr std::size_t mostSkipped = 16;  // files that end the reader

DicomIndexEnd indexOnce(const fs::path& program, const Request& request,
                        const std::function<void(DicomSeries)>& found, base::Progress& progress,
                        double patienceSeconds) {
  ReaderProcess reader(program, request, progress, patienceSeconds);
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

DicomIndexEnd indexDicomBy(const fs::path& program, const fs::path& folder,
                           const std::function<void(DicomSeries)>& found, base::Progress& progress,
                           double patienceSeconds) {
  progress.report(0.0, "looking for series");
  Request request{.task = Task::index, .path = folder.string()};
  std::string firstReason;
  for (;;) {
    try {
      DicomIndexEnd end = indexOnce(program, request, found, progress, patienceSeconds);
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

DicomIndexEnd indexDicom(const fs::path& folder, const std::function<void(DicomSeries)>& found,
                         base::Progress& progress) {
  return indexDicomBy(readerProgram(indexReader), folder, found, progress);
}

DecodedImage previewDicom(const fs::path& file, int frame, base::Progress& progress) {
  Request request{.task = Task::preview, .path = file.string()};
  request.options.timeStep = frame;
  ReaderProcess reader(readerProgram(indexReader), request, progress);
  return receivedImage(reader);
}

}  // namespace isolux::volume
