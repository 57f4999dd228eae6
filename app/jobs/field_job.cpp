#include "app/jobs/field_job.h"

#include <new>
#include <utility>

namespace isolux::app {

FieldJob::FieldJob(std::shared_ptr<const volume::PreparedVolume> volume, const scene::Scene& scene)
    : volume_(std::move(volume)), hitField_(scene.hit.field), derivativesField_(scene.derivatives.field) {
  thread_ = std::thread([this, scene] { run(scene); });
}

FieldJob::~FieldJob() {
  progress_.requestStop();
  thread_.join();
}

bool FieldJob::isFor(const scene::Scene& scene) const {
  return hitField_ == scene.hit.field && derivativesField_ == scene.derivatives.field;
}

void FieldJob::run(const scene::Scene& scene) {
  try {
    volume_->cubicFields->makeFor(scene, progress_);
  } catch (const base::Error& error) {
    error_ = error;
  } catch (const std::bad_alloc&) {
    error_ = base::Error(base::ErrorKind::memory, volume_->volume.name, "",
                         "out of memory while the field is interpolated");
  }
  finished_.store(true, std::memory_order_release);
}

scene::Scene withReadyFields(scene::Scene resolved, const volume::CubicFields& fields) {
  if (resolved.hit.field != scene::Field::trilinear && !fields.find(resolved.hit.field))
    resolved.hit.field = scene::Field::trilinear;
  if (resolved.derivatives.field == scene::Field::cubic_interpolating &&
      !fields.find(resolved.derivatives.field))
    resolved.derivatives.field = scene::Field::cubic;
  return resolved;
}

}  // namespace isolux::app
