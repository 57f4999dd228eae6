// Opens a volume with its voxels left in their file, on a background thread that gives way: what draws level
// 0 of a volume of which a coarser level is in memory. Where it has no index one is made, which reads the
// file once; what is done of it when the task is dropped is kept (volume/large/index_file.h).
#pragma once

#include <memory>

#include "base/task.h"
#include "scene/scene.h"
#include "scene/settings/host_settings.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

struct WholeFile {
  std::shared_ptr<const volume::PreparedVolume> volume;
  scene::HostSettings host;  // with the budgets to draw it by
};
using WholeFileTask = base::Task<WholeFile>;
// `source`: of any level. `machine`: its budgets, but at most half of what memory has left.
std::unique_ptr<WholeFileTask> wholeFileTask(scene::Source source, scene::HostSettings host);

// The scene of a picture of level 0 that shows what a picture of a level of it shows: its view and isovalues,
// and what else the volume decides by itself. `asked`: as the user gave it; `shown`: resolved for the level.
// Throws base::Error{memory} where it cannot be drawn of voxels that stay in their file.
scene::Scene sceneOfWholeFile(const scene::Scene& asked, const scene::Scene& shown,
                              const volume::PreparedVolume& whole);

}  // namespace isolux::app
