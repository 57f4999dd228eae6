// Opens a volume with its voxels left in their file, on a background thread that gives way: what draws level
// 0 of a volume of which a coarser level is in memory. Where it has no index one is made, which reads the
// file once; what is done of it when the job goes is kept (volume/large/index_file.h).
#pragma once

#include <memory>

#include "app/jobs/quiet_job.h"
#include "scene/scene.h"
#include "scene/settings/machine.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

struct WholeFileWork {
  struct Subject {
    scene::Source source;    // of any level
    scene::Machine machine;  // its budgets, but at most half of what memory has left
  };
  static constexpr const char* kDoes = "open the volume itself";
  void run(base::Progress& progress);

  Subject subject;
  std::shared_ptr<const volume::PreparedVolume> volume{};
};

class WholeFileJob : public QuietJob<WholeFileWork> {
 public:
  using QuietJob::QuietJob;
  // After finished(), without an error.
  const std::shared_ptr<const volume::PreparedVolume>& volume() const { return work().volume; }
  const scene::Machine& machine() const { return work().subject.machine; }  // with the budgets to draw it by
};

// The scene of a picture of level 0 that shows what a picture of a level of it shows: its view and isovalues,
// and what else the volume decides by itself. `asked`: as the user gave it; `shown`: resolved for the level.
// Throws base::Error{memory} where it cannot be drawn of voxels that stay in their file.
scene::Scene sceneOfWholeFile(const scene::Scene& asked, const scene::Scene& shown,
                              const volume::PreparedVolume& whole);

}  // namespace isolux::app
