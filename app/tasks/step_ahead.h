// The time step that a user who goes through a film of volumes will want next, loaded before it is asked for.
//
// Only who has gone from one step to another is expected to go on, and only while there is room. Lives on the
// owner's thread, which never waits.
#pragma once

#include <memory>

#include "app/tasks/load_task.h"

namespace isolux::app {

// Returns whether memory has room for another step of this size, and as much again for light and pictures.
bool hasRoomForStep(const volume::PreparedVolume& step);

class StepAhead {
 public:
  // `shown`, of the source `to`, took the place of `from`: the step beyond it, in the same direction, is
  // loaded. Nothing where the two differ in more than their time step, or no step is left.
  void moved(const scene::Source& from, const scene::Source& to, const volume::PreparedVolume& shown);
  // The task that loads this, at work or done; null where that is not so, or it failed. What was begun for
  // another source is stopped.
  std::unique_ptr<LoadTask> take(const scene::Source& source);

 private:
  std::unique_ptr<LoadTask> task_;
  scene::Source source_;  // that it loads
};

}  // namespace isolux::app
