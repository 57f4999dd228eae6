#include "ui/document/mark_reports.h"

#include <algorithm>

#include "base/destroy_in_background.h"

namespace isolux::ui {

namespace {

constexpr int startMilliseconds = 60;  // after the last change: an isovalue that is dragged changes often

bool saysTheSame(const scene::Mark& a, const scene::Mark& b) {
  return a.kind == b.kind && a.points == b.points;
}

}  // namespace

MarkReports::MarkReports(QObject* parent) : QObject(parent) {
  callOnce(startTimer_, startMilliseconds, this, &MarkReports::start);
}

// An evaluator whose task has not ended belongs to that task.
void MarkReports::dropTask() {
  if (task_ && !task_->finished()) evaluator_.reset();
  task_.reset();
}

void MarkReports::setVolume(VolumePointer volume) {
  dropTask();
  if (evaluator_) base::destroyInBackground(std::move(evaluator_));
  evaluator_.reset();
  volume_ = std::move(volume);
  anyway_ = false;
  for (app::MarkReport& report : reports_) {
    report = {};
    report.pending = true;
  }
  if (!marks_.empty()) startTimer_.start();
}

void MarkReports::setScene(const scene::Scene& resolved) {
  const bool holds = evaluator_ && evaluator_->isFor(volume_, resolved);
  resolved_ = resolved;
  if (resolved.marks.empty() && marks_.empty()) return;
  if (holds && resolved.marks == marks_) return;
  std::vector<app::MarkReport> reports(resolved.marks.size());
  bool any = false;
  for (std::size_t i = 0; i < reports.size(); ++i) {
    const auto same = std::find_if(marks_.begin(), marks_.end(), [&](const scene::Mark& mark) {
      return saysTheSame(mark, resolved.marks[i]);
    });
    if (same != marks_.end()) reports[i] = reports_[static_cast<std::size_t>(same - marks_.begin())];
    if (!holds || same == marks_.end()) reports[i].pending = true;
    any = any || reports[i].pending;
  }
  marks_ = resolved.marks;
  reports_ = std::move(reports);
  dropTask();
  if (!holds && evaluator_) base::destroyInBackground(std::move(evaluator_));
  if (!holds) evaluator_.reset();
  startTimer_.stop();
  if (any && volume_) startTimer_.start();
  Q_EMIT changed();
}

void MarkReports::start() {
  if (!volume_) return;
  if (!evaluator_) evaluator_ = std::make_shared<app::MarkEvaluator>(volume_, resolved_, anyway_);
  std::vector<scene::Mark> wanted;
  asked_.clear();
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    if (!reports_[i].pending) continue;
    wanted.push_back(marks_[i]);
    asked_.push_back(i);
  }
  task_.watch(
      app::markTask(evaluator_, std::move(wanted)), [this](auto& task) { takeReports(task); },
      [this] { takeReports(*task_); });
  Q_EMIT changed();
}

void MarkReports::takeReports(app::MarkTask& task) {
  auto results = task.take();
  for (auto& [which, report] : results) reports_[asked_[which]] = std::move(report);
  if (!task_ || !results.empty()) Q_EMIT changed();
}

void MarkReports::measureAnyway() {
  const VolumePointer volume = volume_;
  setVolume(volume);
  anyway_ = true;
  Q_EMIT changed();
}

void MarkReports::stop() {
  startTimer_.stop();
  dropTask();
  for (app::MarkReport& report : reports_) {
    if (!report.pending) continue;
    report = {};
    report.problem = "stopped";
  }
  Q_EMIT changed();
}

}  // namespace isolux::ui
