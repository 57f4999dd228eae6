#include "app/tasks/step_ahead.h"

#include <utility>

#include "base/memory_budget.h"

namespace isolux::app {

namespace {

// With the bounds of boxes and blocks that space is skipped by.
std::size_t bytesOf(const volume::PreparedVolume& volume) {
  return volume.grid().bytes() + volume.grid().geometry().voxelCount();
}

}  // namespace

bool hasRoomForStep(const volume::PreparedVolume& step) {
  return base::machineMemory().left() >= 2 * bytesOf(step);
}

void StepAhead::moved(const scene::Source& from, const scene::Source& to,
                      const volume::PreparedVolume& shown) {
  task_.reset();  // which stops it and does not wait
  scene::Source next = to;
  next.timeStep = from.timeStep;
  if (next != from || to.timeStep == from.timeStep) return;
  next.timeStep = to.timeStep + (to.timeStep > from.timeStep ? 1 : -1);
  if (next.timeStep < 0 || next.timeStep > shown.volume.timeSteps - 1) return;
  if (!hasRoomForStep(shown)) return;
  source_ = next;
  task_ = loadTask(std::move(next), {.aroundDamage = true});
}

std::unique_ptr<LoadTask> StepAhead::take(const scene::Source& source) {
  if (task_ && (source_ != source || (task_->finished() && task_->error()))) task_.reset();
  return std::move(task_);
}

}  // namespace isolux::app
