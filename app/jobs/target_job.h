// Searches the settings that keep an error or a time (app/target) for the view on show, on a background
// thread with a renderer of its own; the owner polls, and stops it when the view or the scene changes.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/target/target_search.h"
#include "base/error.h"
#include "base/progress.h"
#include "base/retire.h"
#include "gi/picture_light.h"

namespace isolux::app {

class TargetJob {
 public:
  struct Subject {
    std::shared_ptr<const volume::PreparedVolume> volume;
    scene::Scene scene;                             // as the user gave it, with the camera of the view
    render::FrameRequest picture;                   // size; no deferred images
    scene::Machine machine;                         // its executor draws what is measured and timed
    std::shared_ptr<const gi::PictureLight> light;  // that is stored: frames that are timed read it
    std::vector<Limit> limits;                      // empty: `milliseconds` is what is to be kept
    double milliseconds = 0.0;
  };
  // Starts at once.
  explicit TargetJob(Subject subject);
  ~TargetJob();  // stops; the thread ends elsewhere
  TargetJob(const TargetJob&) = delete;
  TargetJob& operator=(const TargetJob&) = delete;

  bool finished() const { return work_->finished.load(std::memory_order_acquire); }
  const base::Progress& progress() const { return work_->progress; }
  // After finished(), without an error; none: nothing of the first isosurface is seen.
  const std::optional<TargetAnswer>& answer() const { return work_->answer; }
  // After finished(): that nothing keeps it, or what went wrong.
  const std::optional<base::Error>& error() const { return work_->error; }

  // Searches of this process whose threads have not ended.
  static int running();

 private:
  struct Work {
    Subject subject;
    base::Progress progress;
    std::atomic<bool> finished{false};
    std::optional<TargetAnswer> answer;
    std::optional<base::Error> error;
  };
  static void run(Work& work);
  static void search(Work& work);

  base::RetiringThread<Work> work_;
};

}  // namespace isolux::app
