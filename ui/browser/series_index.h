// The series of a folder as they are found: the index job of the moment, polled. Lives on the GUI thread.
#pragma once

#include <memory>
#include <vector>

#include <QObject>
#include <QString>
#include <QTimer>

#include "app/browser/index_job.h"

namespace isolux::ui {

class SeriesIndex : public QObject {
  Q_OBJECT
 public:
  explicit SeriesIndex(QObject* parent = nullptr);

  void start(const QString& folder);  // instead of what runs
  void stop();                        // what was found stays; ended() is not emitted

  const QString& folder() const { return folder_; }
  bool running() const { return job_ != nullptr; }
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
  void poll();

  QString folder_, problem_;
  std::unique_ptr<app::IndexJob> job_;
  std::vector<volume::DicomSeries> series_;
  volume::DicomIndexEnd end_;
  QTimer timer_;
};

}  // namespace isolux::ui
