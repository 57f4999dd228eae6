// Loads a volume on a background thread; its owner never waits, neither for the thread nor for a volume to be
// freed (base/destroy_in_background.h).
#pragma once

#include <memory>
#include <optional>

#include "base/task.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

// States what may be loaded rather than nothing.
struct LoadInstead {
  bool coarser = false;       // where level 0 does not fit into memory, the finest that does (coarse_level.h)
  bool aroundDamage = false;  // of a file of which parts cannot be read, the rest (Source::aroundDamage)
};
struct LoadedVolume {
  scene::Source source;
  std::shared_ptr<const volume::PreparedVolume> volume;  // never null
};
using LoadTask = base::Task<LoadedVolume>;
// `shown`: a volume that is there; if the source asks for other labels of it, its file is not read again.
std::unique_ptr<LoadTask> loadTask(scene::Source asked, LoadInstead instead = {},
                                   std::optional<LoadedVolume> shown = std::nullopt);

}  // namespace isolux::app
