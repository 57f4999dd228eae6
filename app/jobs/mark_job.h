// Measures marks on a background thread, the quick ones first.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "app/marks/mark_evaluator.h"
#include "base/task.h"

namespace isolux::app {

// Its news: which of the marks have been measured, with their reports. What failed, as for want of memory, is
// the mark's problem.
using MarkTask = base::Task<void, std::vector<std::pair<std::size_t, MarkReport>>>;
// Nobody else uses the evaluator until it has finished.
std::unique_ptr<MarkTask> markTask(std::shared_ptr<MarkEvaluator> evaluator, std::vector<scene::Mark> marks);

}  // namespace isolux::app
