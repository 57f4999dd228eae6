// What a scene's pictures need of a volume beside its voxels, and what of it is automatic: fields
// (volume/field/cubic_fields.h), scales of derivatives (volume/statistics/derivative_choices.h) and what is
// hidden of its pieces (volume/pieces). Made on a background thread, which the owner polls; meanwhile
// pictures are drawn with what is there.
#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include "base/error.h"
#include "base/progress.h"
#include "base/retire.h"
#include "scene/scene.h"
#include "volume/prepared_volume.h"

namespace isolux::app {

// Fills in what is automatic about derivatives and makes the fields that pictures of the scene read, with its
// deferred images where those are wanted. For those who may wait.
void completeFields(scene::Scene& resolved, const volume::PreparedVolume& volume, bool images,
                    base::Progress& progress);

// Whether a picture of the scene finds all that, at rest too (app/jobs/rest_scene.h).
bool fieldsAreReady(const scene::Scene& resolved, const volume::PreparedVolume& volume);

// The scene with what can be drawn now. What is not made yet is replaced: hits by those of the trilinear
// field, derivatives by those of the B-spline of the samples, scales by those of `last`, else by none; pieces
// are shown. `last`: of the last picture of the volume that had all it asked for.
scene::Scene withReadyFields(scene::Scene resolved, const volume::PreparedVolume& volume,
                             const scene::Derivatives& last = {});

class FieldJob {
 public:
  FieldJob(std::shared_ptr<const volume::PreparedVolume> volume,
           const scene::Scene& scene);  // starts at once
  ~FieldJob();                          // stops; the thread ends elsewhere (base/retire.h)
  FieldJob(const FieldJob&) = delete;
  FieldJob& operator=(const FieldJob&) = delete;

  bool isFor(const scene::Scene& scene) const;  // which needs the same
  bool finished() const { return work_->finished.load(std::memory_order_acquire); }
  const base::Progress& progress() const { return work_->progress; }
  // After finished(): what went wrong.
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
