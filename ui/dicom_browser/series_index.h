// The series of a folder as they are found: the index task of the moment. Lives on the GUI thread.
#pragma once

#include <vector>

#include <QObject>
#include <QString>

#include "app/browser/index_job.h"
#include "ui/document/background_task.h"

namespace isolux::ui {

class SeriesIndex : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  void start(const QString& folder);  // instead of what runs
  void stop() { task_.reset(); }      // what was found stays; ended() is not emitted

  const QString& folder() const { return folder_; }
  bool running() const { return bool(task_); }
  const std::vector<volume::DicomSeries>& series() const { return series_; }
  // Of the last that ran to its end.
  const volume::DicomIndexEnd& end() const { return end_; }
  const QString& problem() const { return problem_; }  // why it could not; empty: it could

 Q_SIGNALS:
  void started();
  void progressed(double fraction);
  void changed();  // series() has more, or knows more of some
  void ended();

 private:
  void takeSeries(app::IndexTask& task);
  void takeEnd(app::IndexTask& task);

  QString folder_, problem_;
  BackgroundTask<volume::DicomIndexEnd, std::vector<volume::DicomSeries>> task_;
  std::vector<volume::DicomSeries> series_;
  volume::DicomIndexEnd end_;
};

}  // namespace isolux::ui
