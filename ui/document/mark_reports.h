// What the scene's marks say, measured beside the window's work and kept as long as it holds.
//
// A change of the camera or the look measures nothing anew; a new mark is measured alone. Lives on the GUI
// thread; a MarkJob works beside it and is polled.
#pragma once

#include <memory>
#include <vector>

#include <QObject>
#include <QTimer>

#include "app/jobs/mark_job.h"
#include "ui/document/document.h"

namespace isolux::ui {

class MarkReports : public QObject {
  Q_OBJECT
 public:
  explicit MarkReports(QObject* parent = nullptr);

  void setVolume(VolumePointer volume);
  void setScene(const scene::Scene& resolved);
  void measureAnyway();  // lengths too that are doubtful, until another volume is opened
  void stop();           // what is not measured yet stays so until something changes

  const std::vector<scene::Mark>& marks() const { return marks_; }
  const std::vector<app::MarkReport>& reports() const { return reports_; }  // one for each mark
  bool measuring() const { return job_ != nullptr || startTimer_.isActive(); }

 Q_SIGNALS:
  void changed();  // marks, reports, or whether it is measuring

 private:
  void start();
  void poll();
  void dropJob();

  VolumePointer volume_;
  scene::Scene resolved_;
  std::vector<scene::Mark> marks_;
  std::vector<app::MarkReport> reports_;
  std::shared_ptr<app::MarkEvaluator> evaluator_;
  bool anyway_ = false;
  std::unique_ptr<app::MarkJob> job_;
  std::vector<std::size_t> asked_;  // of the job: its marks' places in marks_
  QTimer startTimer_, pollTimer_;
};

}  // namespace isolux::ui
