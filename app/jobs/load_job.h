// Loads a volume on a background thread; the owner polls, and never waits: neither for the thread nor for a
// volume to be freed (base/retire.h).
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <utility>

#include "base/progress.h"
#include "base/retire.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

class LoadJob {
 public:
  // What may be loaded rather than nothing.
  struct Instead {
    bool coarser = false;  // where level 0 does not fit into memory, the finest that does (coarse_level.h)
    bool aroundDamage = false;  // of a file of which parts cannot be read, the rest (Source::aroundDamage)
  };

  // Starts at once.
  explicit LoadJob(scene::Source source) : LoadJob(std::move(source), {}) {}
  LoadJob(scene::Source source, Instead instead);
  ~LoadJob();  // stops

  const scene::Source& source() const { return work_->source; }  // as it was asked for
  base::Progress& progress() { return work_->progress; }
  bool finished() const { return work_->finished.load(std::memory_order_acquire); }
  // After finished(): what was loaded; the volume, or the error.
  const scene::Source& loaded() const { return work_->loaded; }
  std::shared_ptr<const volume::PreparedVolume> volume() const { return work_->volume; }
  const std::optional<base::Error>& error() const { return work_->error; }

 private:
  struct Work {
    scene::Source source, loaded;
    Instead instead;
    base::Progress progress;
    std::atomic<bool> finished{false};
    std::shared_ptr<const volume::PreparedVolume> volume;
    std::optional<base::Error> error;
  };
  static void run(Work& work);
  static void load(Work& work);

  base::RetiringThread<Work> work_;
};

}  // namespace isolux::app
