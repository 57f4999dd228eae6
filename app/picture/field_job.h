// Computes what a scene's frames need of a volume in addition to its voxels, and its automatic values.
//
// These are fields (volume/derived/cubic_fields.h), scales of derivatives
// (volume/prepared/derivative_choices.h) and hidden components (volume/pieces). A background thread
// computes them, and the owner polls it; meanwhile frames are drawn with what is ready.
#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include "base/error.h"
#include "base/progress.h"
#include "base/retire.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

// Chooses automatic settings of derivatives and computes the fields that frames of the scene read, with its
// AOVs if `images`. Blocks until done.
void completeFields(scene::Scene& resolved, const volume::PreparedVolume& volume, bool images,
                    base::Progress& progress);

// Returns whether all that is ready for a frame of the scene, idle frames included
// (app/picture/rest_scene.h).
bool fieldsAreReady(const scene::Scene& resolved, const volume::PreparedVolume& volume);

// Returns the scene with what can be drawn now. Missing data are replaced: hits by those of the trilinear
// field, derivatives by those of the smoothing B-spline, scales by those of `last`, else by none; all
// components are shown. `last`: of the last frame of the volume for which everything was ready.
scene::Scene withReadyFields(scene::Scene resolved, const volume::PreparedVolume& volume,
                             const scene::Derivatives& last = {});

class FieldJob {
 public:
  FieldJob(std::shared_ptr<const volume::PreparedVolume> volume,
           const scene::Scene& scene);  // starts at once
  ~FieldJob();                          // stops; the thread ends in the background (base/retire.h)
  FieldJob(const FieldJob&) = delete;
  FieldJob& operator=(const FieldJob&) = delete;

  bool isFor(const scene::Scene& scene) const;  // returns whether `scene` needs the same
  bool finished() const { return work_->finished.load(std::memory_order_acquire); }
  const base::Progress& progress() const { return work_->progress; }
  // Returns the error after finished(), if any.
  const std::optional<base::Error>& error() const { return work_->error; }

 private:
  struct Work {
    std::shared_ptr<const volume::PreparedVolume> volume;
    scene::Scene scene;
    base::Progress progress;
    std::atomic<bool> finished{false};
    std::optional<base::Error> error;
  };
  static void run(Work& work);

  base::RetiringThread<Work> work_;
};

}  // namespace isolux::app
