// Measures what knobs cost and err by in a scene's view on a background thread, with a renderer of its own.
#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "app/study/study.h"
#include "base/task.h"

namespace isolux::app {

struct StudySubject {
  std::shared_ptr<const volume::PreparedVolume> volume;
  scene::Scene scene;  // as the user gave it
  scene::Machine machine;
  std::vector<Knob> knobs;
  glm::ivec2 size{0};  // pixels
  int repeat = 3;      // frames of each setting
};
// Its news: the knobs that have been studied, in their order.
using StudyTask = base::Task<void, std::vector<KnobStudy>>;
std::unique_ptr<StudyTask> studyTask(StudySubject asked);

}  // namespace isolux::app
