// Loads a volume on a background thread; the owner polls.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <thread>

#include "scene/progress.h"
#include "scene/scene.h"
#include "volume/prepared_volume.h"

namespace isolux::app {

class LoadJob {
 public:
  explicit LoadJob(scene::Source source);  // starts at once
  ~LoadJob();                              // stops and waits

  const scene::Source& source() const { return source_; }
  scene::Progress& progress() { return progress_; }
  bool finished() const { return finished_.load(std::memory_order_acquire); }
  // After finished(): the volume, or the error.
  std::shared_ptr<const volume::PreparedVolume> volume() const { return volume_; }
  const std::optional<scene::Error>& error() const { return error_; }

 private:
  scene::Source source_;
  scene::Progress progress_;
  std::atomic<bool> finished_{false};
  std::shared_ptr<const volume::PreparedVolume> volume_;
  std::optional<scene::Error> error_;
  std::thread thread_;
};

}  // namespace isolux::app
