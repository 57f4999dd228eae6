// Bounds the errors of a picture that is shown (app/accuracy) on a background thread, with a renderer of its
// own that casts on the processor; the owner polls, and stops it when the user needs the machine.
#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include "app/accuracy/accuracy.h"
#include "base/error.h"
#include "base/progress.h"
#include "base/retire.h"
#include "gi/picture_light.h"

namespace isolux::app {

class AccuracyJob {
 public:
  struct Subject {
    std::shared_ptr<const volume::PreparedVolume> volume;
    scene::Scene scene;  // resolved, as it is shown in motion; what is there at rest is found here
    std::shared_ptr<const gi::PictureLight> light;  // that it is lit by; null: none
    glm::ivec2 size{0};                             // pixels
    bool onProcessor = false;                       // who drew it: its arithmetic is what is bounded
  };
  // Starts at once.
  explicit AccuracyJob(Subject subject);
  ~AccuracyJob();  // stops; the thread ends elsewhere
  AccuracyJob(const AccuracyJob&) = delete;
  AccuracyJob& operator=(const AccuracyJob&) = delete;

  bool finished() const { return work_->finished.load(std::memory_order_acquire); }
  const base::Progress& progress() const { return work_->progress; }
  // After finished(): one of them is there.
  const std::optional<Accuracy>& accuracy() const { return work_->accuracy; }
  const std::optional<base::Error>& error() const { return work_->error; }

 private:
  struct Work {
    Subject subject;
    base::Progress progress;
    std::atomic<bool> finished{false};
    std::optional<Accuracy> accuracy;
    std::optional<base::Error> error;
  };
  static void run(Work& work);
  static void measure(Work& work);

  base::RetiringThread<Work> work_;
};

}  // namespace isolux::app
