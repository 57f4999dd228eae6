// Searches the settings that keep an error or a time (app/target) for the view on show, on a background
// thread with a renderer of its own.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/target/target_search.h"
#include "base/task.h"
#include "gi/picture_light.h"

namespace isolux::app {

struct TargetSubject {
  std::shared_ptr<const volume::PreparedVolume> volume;
  scene::Scene scene;                             // as the user gave it, with the camera of the view
  render::FrameRequest picture;                   // size; no deferred images
  scene::Machine machine;                         // its executor draws what is measured and timed
  std::shared_ptr<const gi::PictureLight> light;  // that is stored: frames that are timed read it
  std::vector<Limit> limits;                      // empty: `milliseconds` is what is to be kept
  double milliseconds = 0.0;
};
// Its value: none where nothing of the first isosurface is seen. Its error: also that nothing keeps it.
using TargetTask = base::Task<std::optional<TargetAnswer>>;
std::unique_ptr<TargetTask> targetTask(TargetSubject asked);

// Searches of this process that have not ended.
int runningSearches();

}  // namespace isolux::app
