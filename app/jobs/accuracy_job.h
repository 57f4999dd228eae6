// Bounds the errors of a picture that is shown (app/accuracy) on a background thread, with a renderer of its
// own that casts on the processor.
#pragma once

#include <memory>

#include "app/accuracy/accuracy.h"
#include "base/task.h"
#include "gi/picture_light.h"

namespace isolux::app {

struct AccuracySubject {
  std::shared_ptr<const volume::PreparedVolume> volume;
  scene::Scene scene;  // resolved, as it is shown in motion; what is there at rest is found here
  std::shared_ptr<const gi::PictureLight> light;  // that it is lit by; null: none
  glm::ivec2 size{0};                             // pixels
  bool onProcessor = false;                       // who drew it: its arithmetic is what is bounded
  bool keepImages = false;                        // what each pixel errs by is wanted, too
};
struct MeasuredPicture {
  Accuracy accuracy;
  std::shared_ptr<const PictureErrors> images;  // null: not wanted
};
using AccuracyTask = base::Task<MeasuredPicture>;
std::unique_ptr<AccuracyTask> accuracyTask(AccuracySubject asked);

}  // namespace isolux::app
