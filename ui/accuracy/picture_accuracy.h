// How accurate the picture on screen is: measured on a background thread (app/accuracy/accuracy.h), and known
// only while the picture that it was measured of is on show.
#pragma once

#include <memory>
#include <optional>

#include <QObject>

#include "app/accuracy/accuracy.h"
#include "ui/document/background_task.h"

namespace isolux::ui {

class PictureAccuracy : public QObject {
  Q_OBJECT
 public:
  using Subject = app::AccuracySubject;

  using QObject::QObject;

  // The finished picture on show; none: there is none, or nobody wants to know. A job for another one ends.
  void show(std::optional<Subject> subject);
  bool wanted() const;            // one is on show that was not measured
  void measure();                 // it is, unless it is measured already
  void drop() { task_.reset(); }  // the job ends; measure() begins anew
  void forget();                  // all of the volume that is no more
  // Whether what each pixel errs by is wanted, too, which takes memory.
  void keepImages(bool kept);

  bool working() const { return bool(task_); }
  const std::optional<app::Accuracy>& known() const;         // of the picture on show
  std::shared_ptr<const app::PictureErrors> images() const;  // of it; null: not known, or not kept
  const std::optional<Subject>& subject() const { return shown_; }
  int jobsBegun() const { return jobsBegun_; }

 Q_SIGNALS:
  void changed();  // what is known
  void ended();    // the job, by itself

 private:
  void take(app::AccuracyTask& task);

  std::optional<Subject> shown_;
  std::optional<Subject> measured_;  // what was measured last, and with what result: none, it failed
  std::optional<app::Accuracy> accuracy_;
  std::shared_ptr<const app::PictureErrors> images_;  // of measured_
  bool keepsImages_ = false;
  BackgroundTask<app::MeasuredPicture> task_;
  int jobsBegun_ = 0;
};

}  // namespace isolux::ui
