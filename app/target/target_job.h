// Searches the settings that keep an error or a time (app/target) for the view on show, on a background
// thread with a renderer of its own; stopped when the view or the scene changes.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/jobs/quiet_job.h"
#include "app/target/target_search.h"
#include "gi/picture_light.h"

namespace isolux::app {

struct TargetWork {
  struct Subject {
    std::shared_ptr<const volume::PreparedVolume> volume;
    scene::Scene scene;                             // as the user gave it, with the camera of the view
    render::FrameRequest picture;                   // size; no deferred images
    scene::Machine machine;                         // its executor draws what is measured and timed
    std::shared_ptr<const gi::PictureLight> light;  // that is stored: frames that are timed read it
    std::vector<Limit> limits;                      // empty: `milliseconds` is what is to be kept
    double milliseconds = 0.0;
  };
  static constexpr const char* kDoes = "choose settings";
  void run(base::Progress& progress);
  static std::shared_ptr<const void> counted();  // one more search, until it goes

  Subject subject;
  std::optional<TargetAnswer> answer{};
  std::shared_ptr<const void> counts = counted();
};

// Its error, after finished(): that nothing keeps it, or what went wrong.
class TargetJob : public QuietJob<TargetWork> {
 public:
  using QuietJob::QuietJob;
  // After finished(), without an error; none: nothing of the first isosurface is seen.
  const std::optional<TargetAnswer>& answer() const { return work().answer; }

  // Searches of this process that have not ended.
  static int running();
};

}  // namespace isolux::app
