#include "app/browser/index_job.h"

#include <algorithm>
#include <utility>

#include "app/process/caught_error.h"

namespace isolux::app {

void addSeries(std::vector<volume::DicomSeries>& all, volume::DicomSeries series) {
  const auto same =
      std::find_if(all.begin(), all.end(), [&](const auto& known) { return known.series == series.series; });
  if (same == all.end())
    all.push_back(std::move(series));
  else
    *same = std::move(series);
}

IndexJob::IndexJob(std::string folder)
    : folder_(folder),
      work_(
          [&] {
            auto work = std::make_shared<Work>();
            work->folder = std::move(folder);
            return work;
          }(),
          run) {}

IndexJob::~IndexJob() {
  work_->progress.requestStop();
}

std::vector<volume::DicomSeries> IndexJob::take() {
  const std::lock_guard lock(work_->mutex);
  return std::exchange(work_->found, {});
}

void IndexJob::run(Work& work) {
  const auto keep = [&](volume::DicomSeries series) {
    const std::lock_guard lock(work.mutex);
    addSeries(work.found, std::move(series));
  };
  work.error = caughtError(work.folder, "list the series",
                           [&] { work.end = volume::indexDicom(work.folder, keep, work.progress); });
  work.finished.store(true, std::memory_order_release);
}

PreviewJob::PreviewJob(std::string file, int frame)
    : work_(
          [&] {
            auto work = std::make_shared<Work>();
            work->file = std::move(file);
            work->frame = frame;
            return work;
          }(),
          run) {}

PreviewJob::~PreviewJob() {
  work_->progress.requestStop();
}

void PreviewJob::run(Work& work) {
  // No picture where that fails: opening the series says why.
  caughtError(work.file, "preview",
              [&] { work.image = volume::previewDicom(work.file, work.frame, work.progress); });
  work.finished.store(true, std::memory_order_release);
}

}  // namespace isolux::app
