// Makes what a scene's cubic fields need of a volume (volume/field/cubic_fields.h) on a background thread;
// the owner polls. Meanwhile pictures are drawn with the fields that are there.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <thread>

#include "base/error.h"
#include "base/progress.h"
#include "scene/scene.h"
#include "volume/prepared_volume.h"

namespace isolux::app {

class FieldJob {
 public:
  FieldJob(std::shared_ptr<const volume::PreparedVolume> volume,
           const scene::Scene& scene);  // starts at once
  ~FieldJob();                          // stops and waits: at most 100 ms

  bool isFor(const scene::Scene& scene) const;  // the same fields
  bool finished() const { return finished_.load(std::memory_order_acquire); }
  const base::Progress& progress() const { return progress_; }
  // After finished(): what went wrong.
  const std::optional<base::Error>& error() const { return error_; }

 private:
  void run(const scene::Scene& scene);

  std::shared_ptr<const volume::PreparedVolume> volume_;
  scene::Field hitField_, derivativesField_;
  base::Progress progress_;
  std::atomic<bool> finished_{false};
  std::optional<base::Error> error_;
  std::thread thread_;
};

// The scene with fields that are not made yet replaced: hits by those of the trilinear field, derivatives by
// those of the B-spline of the samples.
scene::Scene withReadyFields(scene::Scene resolved, const volume::CubicFields& fields);

}  // namespace isolux::app
