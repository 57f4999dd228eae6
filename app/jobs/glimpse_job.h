// A picture of a volume that is still being read (volume/large/glimpse.h), for whoever waits for it.
#pragma once

#include <optional>

#include "app/jobs/quiet_job.h"
#include "render/graph/frame.h"
#include "scene/scene.h"
#include "volume/large/glimpse.h"

namespace isolux::app {

struct GlimpseWork {
  struct Subject {
    scene::Scene scene;  // that will be shown: its look, and its view where it has one
    glm::ivec2 size{0};  // pixels
    double pixelRatio = 1.0;
    std::size_t least = volume::kGlimpseLeastBytes;
  };
  static constexpr const char* kDoes = "take a first look at the volume";
  static constexpr bool kIsAwaited = true;
  void run(base::Progress& progress);

  Subject subject;
  render::ColorImage picture{};  // none: there is no glimpse
  glm::ivec3 step{1};
  bool fromIndex = false;
};

class GlimpseJob : public QuietJob<GlimpseWork> {
 public:
  using QuietJob::QuietJob;
  // After finished(), without an error; of no pixels where there is none.
  const render::ColorImage& picture() const { return work().picture; }
  glm::ivec3 step() const { return work().step; }  // voxels of the volume from one that is seen to the next
  bool isFromIndex() const { return work().fromIndex; }  // boxes of so many voxels are
};

}  // namespace isolux::app
