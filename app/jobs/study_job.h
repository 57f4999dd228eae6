// Measures what knobs cost and err by in a scene's view on a background thread, with a renderer of its own;
// the owner polls, and stops it when the user needs the machine.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "app/study/study.h"
#include "base/error.h"
#include "base/progress.h"
#include "base/retire.h"

namespace isolux::app {

class StudyJob {
 public:
  struct Subject {
    std::shared_ptr<const volume::PreparedVolume> volume;
    scene::Scene scene;  // as the user gave it
    scene::Machine machine;
    std::vector<Knob> knobs;
    glm::ivec2 size{0};  // pixels
    int repeat = 3;      // frames of each setting
  };
  // Starts at once.
  explicit StudyJob(Subject subject);
  ~StudyJob();  // stops; the thread ends elsewhere
  StudyJob(const StudyJob&) = delete;
  StudyJob& operator=(const StudyJob&) = delete;

  std::vector<KnobStudy> take();  // those that were finished since, in the order of the knobs
  // Every knob is studied, or none will be any more; then take() gives the last ones.
  bool finished() const { return work_->finished.load(std::memory_order_acquire); }
  const base::Progress& progress() const { return work_->progress; }
  const std::optional<base::Error>& error() const { return work_->error; }  // after finished()

 private:
  struct Work {
    Subject subject;
    base::Progress progress;
    std::mutex mutex;
    std::vector<KnobStudy> found;  // guarded by `mutex`
    std::atomic<bool> finished{false};
    std::optional<base::Error> error;
  };
  static void run(Work& work);
  static void study(Work& work);

  base::RetiringThread<Work> work_;
};

}  // namespace isolux::app
