#include "ui/browser/series_index.h"

namespace isolux::ui {

SeriesIndex::SeriesIndex(QObject* parent) : QObject(parent) {
  timer_.setInterval(50);
  connect(&timer_, &QTimer::timeout, this, &SeriesIndex::poll);
}

void SeriesIndex::start(const QString& folder) {
  stop();
  folder_ = folder;
  problem_.clear();
  series_.clear();
  end_ = {};
  job_ = std::make_unique<app::IndexJob>(folder.toStdString());
  timer_.start();
  Q_EMIT started();
  Q_EMIT changed();
}

void SeriesIndex::stop() {
  timer_.stop();
  job_.reset();
}

void SeriesIndex::poll() {
  const bool finished = job_->finished();  // before the last of it is taken
  const std::vector<volume::DicomSeries> found = job_->take();
  for (const volume::DicomSeries& series : found) app::addSeries(series_, series);
  if (finished) {
    end_ = job_->end();
    if (job_->error()) problem_ = QString::fromStdString(job_->error()->what());
    stop();
  } else {
    Q_EMIT progressed(job_->progress().fraction());
  }
  if (!found.empty()) Q_EMIT changed();
  if (finished) Q_EMIT ended();
}

}  // namespace isolux::ui
