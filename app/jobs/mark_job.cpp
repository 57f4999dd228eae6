#include "app/jobs/mark_job.h"

namespace isolux::app {

namespace {

MarkReport reportOf(MarkEvaluator& evaluator, const scene::Mark& mark, base::Progress& progress) {
  MarkReport report;
  const auto error = base::caughtError("", "measure", [&] { report = evaluator.evaluate(mark, progress); });
  if (error && error->kind() == base::ErrorKind::interrupted) throw *error;
  if (error) report.problem = error->what();
  return report;
}

}  // namespace

std::unique_ptr<MarkTask> markTask(std::shared_ptr<MarkEvaluator> evaluator, std::vector<scene::Mark> marks) {
  const auto work = [evaluator = std::move(evaluator), marks = std::move(marks)](base::Progress& progress,
                                                                                 const auto& tell) {
    for (const bool slow : {false, true})
      for (std::size_t i = 0; i < marks.size(); ++i) {
        if (isSlow(marks[i].kind) != slow) continue;
        MarkReport report = reportOf(*evaluator, marks[i], progress);
        tell([&](auto& reports) { reports.emplace_back(i, std::move(report)); });
      }
  };
  return MarkTask::start({"", "measure"}, work);
}

}  // namespace isolux::app
