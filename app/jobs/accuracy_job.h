// Bounds the errors of a picture that is shown (app/accuracy) on a background thread, with a renderer of its
// own that casts on the processor.
#pragma once

#include <memory>
#include <optional>

#include "app/accuracy/accuracy.h"
#include "app/jobs/quiet_job.h"
#include "gi/picture_light.h"

namespace isolux::app {

struct AccuracyWork {
  struct Subject {
    std::shared_ptr<const volume::PreparedVolume> volume;
    scene::Scene scene;  // resolved, as it is shown in motion; what is there at rest is found here
    std::shared_ptr<const gi::PictureLight> light;  // that it is lit by; null: none
    glm::ivec2 size{0};                             // pixels
    bool onProcessor = false;                       // who drew it: its arithmetic is what is bounded
    bool keepImages = false;                        // what each pixel errs by is wanted, too
  };
  static constexpr const char* kDoes = "bound the errors of the image";
  void run(base::Progress& progress);

  Subject subject;
  std::optional<Accuracy> accuracy{};
  std::shared_ptr<const PictureErrors> images{};
};

class AccuracyJob : public QuietJob<AccuracyWork> {
 public:
  using QuietJob::QuietJob;
  // After finished(), without an error.
  const std::optional<Accuracy>& accuracy() const { return work().accuracy; }
  const std::shared_ptr<const PictureErrors>& images() const { return work().images; }  // null: not wanted
};

}  // namespace isolux::app
