// Measures marks on a background thread, the quick ones first; the owner polls for what is there.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "app/marks/mark_evaluator.h"
#include "base/progress.h"
#include "base/retire.h"

namespace isolux::app {

class MarkJob {
 public:
  using Result = std::pair<std::size_t, MarkReport>;  // which of the marks

  // Starts at once. Nobody else uses the evaluator until finished().
  MarkJob(std::shared_ptr<MarkEvaluator> evaluator, std::vector<scene::Mark> marks);
  ~MarkJob();  // stops; the end is not waited for (base/retire.h)

  bool finished() const { return work_->finished.load(std::memory_order_acquire); }
  // What has been measured since the last call. Marks that were stopped have none; what failed for want of
  // memory is the mark's problem.
  std::vector<Result> take();

 private:
  struct Work {
    std::shared_ptr<MarkEvaluator> evaluator;
    std::vector<scene::Mark> marks;
    base::Progress progress;
    std::mutex mutex;
    std::vector<Result> results;  // guarded by mutex
    std::atomic<bool> finished{false};
  };
  static void run(Work& work);
  static MarkReport reportOf(Work& work, const scene::Mark& mark);

  base::RetiringThread<Work> work_;
};

}  // namespace isolux::app
