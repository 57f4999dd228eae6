// Loads a volume on a background thread; the owner polls, and never waits: neither for the thread nor for a
// volume to be freed (base/retire.h).
#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include "base/progress.h"
#include "base/retire.h"
#include "scene/scene.h"
#include "volume/prepared_volume.h"

namespace isolux::app {

class LoadJob {
 public:
  // Starts at once. `coarser`: of a volume that does not fit into memory, and of which no level is asked for,
  // the finest level that fits (volume/bricks/coarse_level.h).
  explicit LoadJob(scene::Source source, bool coarser = false);
  ~LoadJob();  // stops

  const scene::Source& source() const { return work_->source; }  // as it was asked for
  base::Progress& progress() { return work_->progress; }
  bool finished() const { return work_->finished.load(std::memory_order_acquire); }
  // After finished(): what was loaded, with its level; the volume, or the error.
  scene::Source loaded() const;
  std::shared_ptr<const volume::PreparedVolume> volume() const { return work_->volume; }
  const std::optional<base::Error>& error() const { return work_->error; }

 private:
  struct Work {
    scene::Source source;
    bool coarser = false;
    int level = 0;  // that was loaded
    base::Progress progress;
    std::atomic<bool> finished{false};
    std::shared_ptr<const volume::PreparedVolume> volume;
    std::optional<base::Error> error;
  };
  static void run(Work& work);

  base::RetiringThread<Work> work_;
};

}  // namespace isolux::app
