#include "app/browser/index_job.h"

#include <algorithm>
#include <utility>

namespace isolux::app {

void addSeries(std::vector<volume::DicomSeries>& all, volume::DicomSeries series) {
  const auto same =
      std::ranges::find_if(all, [&](const auto& known) { return known.series == series.series; });
  if (same == all.end())
    all.push_back(std::move(series));
  else
    *same = std::move(series);
}

std::unique_ptr<IndexTask> indexTask(const std::string& folder) {
  return IndexTask::start({folder, "list the series"}, [folder](base::Progress& progress, const auto& tell) {
    const auto keep = [&](volume::DicomSeries series) {
      tell([&](std::vector<volume::DicomSeries>& found) { addSeries(found, std::move(series)); });
    };
    return volume::indexDicom(folder, keep, progress);
  });
}

std::unique_ptr<PreviewTask> previewTask(const std::string& file, int frame) {
  return PreviewTask::start({file, "preview"}, [file, frame](base::Progress& progress) {
    return volume::previewDicom(file, frame, progress);
  });
}

}  // namespace isolux::app
