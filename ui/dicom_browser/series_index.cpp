#include "ui/dicom_browser/series_index.h"

namespace isolux::ui {

void SeriesIndex::start(const QString& folder) {
  stop();
  folder_ = folder;
  problem_.clear();
  series_.clear();
  end_ = {};
  task_.watch(
      app::indexTask(folder.toStdString()), [this](auto& task) { takeEnd(task); },
      [this] {
        const double fraction = task_->progress().fraction();
        takeSeries(*task_);  // which may stop it
        Q_EMIT progressed(fraction);
      });
  Q_EMIT started();
  Q_EMIT changed();
}

void SeriesIndex::takeSeries(app::IndexTask& task) {
  const std::vector<volume::DicomSeries> found = task.take();
  for (const volume::DicomSeries& series : found) app::addSeries(series_, series);
  if (!found.empty()) Q_EMIT changed();
}

void SeriesIndex::takeEnd(app::IndexTask& task) {
  if (task.error())
    problem_ = QString::fromStdString(task.error()->what());
  else
    end_ = task.value();
  takeSeries(task);
  Q_EMIT ended();
}

}  // namespace isolux::ui
