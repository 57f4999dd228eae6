// Measures what knobs cost and err by in a scene's view on a background thread, with a renderer of its own.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "app/jobs/quiet_job.h"
#include "app/study/study.h"

namespace isolux::app {

struct StudyWork {
  struct Subject {
    std::shared_ptr<const volume::PreparedVolume> volume;
    scene::Scene scene;  // as the user gave it
    scene::Machine machine;
    std::vector<Knob> knobs;
    glm::ivec2 size{0};  // pixels
    int repeat = 3;      // frames of each setting
  };
  static constexpr const char* kDoes = "measure accuracy";
  void run(base::Progress& progress);

  Subject subject;
  std::mutex mutex{};
  std::vector<KnobStudy> found{};  // guarded by `mutex`
};

// Finished: every knob is studied, or none will be any more; then take() gives the last ones.
class StudyJob : public QuietJob<StudyWork> {
 public:
  using QuietJob::QuietJob;
  std::vector<KnobStudy> take();  // those that were finished since, in the order of the knobs
};

}  // namespace isolux::app
