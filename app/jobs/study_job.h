// Measures what knobs cost and err by in a scene's view on a background thread, with a renderer of its own.
#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "app/study/study.h"
#include "base/task.h"

namespace isolux::app {

// Its news: the knobs that have been studied, in their order.
using StudyTask = base::Task<void, std::vector<KnobStudy>>;
std::unique_ptr<StudyTask> studyTask(StudySubject subject, std::vector<Knob> knobs);

}  // namespace isolux::app
