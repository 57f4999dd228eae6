#include "app/jobs/mark_job.h"

#include "app/process/caught_error.h"

namespace isolux::app {

MarkJob::MarkJob(std::shared_ptr<MarkEvaluator> evaluator, std::vector<scene::Mark> marks)
    : work_(
          [&] {
            auto work = std::make_shared<Work>();
            work->evaluator = std::move(evaluator);
            work->marks = std::move(marks);
            return work;
          }(),
          run) {}

MarkJob::~MarkJob() {
  work_->progress.requestStop();
}

std::vector<MarkJob::Result> MarkJob::take() {
  const std::scoped_lock lock(work_->mutex);
  return std::exchange(work_->results, {});
}

MarkReport MarkJob::reportOf(Work& work, const scene::Mark& mark) {
  MarkReport report;
  const auto error =
      caughtError("", "measure", [&] { report = work.evaluator->evaluate(mark, work.progress); });
  if (error && error->kind() == base::ErrorKind::interrupted) throw *error;
  if (error) report.problem = error->what();
  return report;
}

void MarkJob::run(Work& work) {
  // Stopped: nobody asks any more.
  caughtError("", "measure", [&] {
    for (const bool slow : {false, true})
      for (std::size_t i = 0; i < work.marks.size(); ++i) {
        if (isSlow(work.marks[i].kind) != slow) continue;
        MarkReport report = reportOf(work, work.marks[i]);
        const std::scoped_lock lock(work.mutex);
        work.results.emplace_back(i, std::move(report));
      }
  });
  work.finished.store(true, std::memory_order_release);
}

}  // namespace isolux::app
