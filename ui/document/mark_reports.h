// What the scene's marks say, measured beside the window's work and kept as long as it holds.
//
// A change of the camera or the look measures nothing anew; a new mark is measured alone. Lives on the GUI
// thread.
#pragma once

#include <memory>
#include <vector>

#include <QObject>
#include <QTimer>

#include "app/marks/mark_evaluator.h"
#include "ui/document/background_task.h"
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
  bool measuring() const { return task_ || startTimer_.isActive(); }

 Q_SIGNALS:
  void changed();  // marks, reports, or whether it is measuring

 private:
  void start();
  void takeReports(app::MarkTask& task);
  void dropTask();

  VolumePointer volume_;
  scene::Scene resolved_;
  std::vector<scene::Mark> marks_;
  std::vector<app::MarkReport> reports_;
  std::shared_ptr<app::MarkEvaluator> evaluator_;
  bool anyway_ = false;
  BackgroundTask<void, std::vector<std::pair<std::size_t, app::MarkReport>>> task_;
  std::vector<std::size_t> asked_;  // of the task: its marks' places in marks_
  QTimer startTimer_;
};

}  // namespace isolux::ui
