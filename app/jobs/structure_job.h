// Finds what a coarser level hides of the picture on screen (app/accuracy/hidden_structure.h) and marks it,
// on a background thread, with a renderer of its own that casts on the processor.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/accuracy/hidden_structure.h"
#include "app/jobs/overlay_job.h"
#include "base/task.h"

namespace isolux::app {

// Keeps what outlives a picture: the next task of the same volume takes it over. All null: nothing is known yet.
struct KnownStructure {
  std::shared_ptr<const volume::IndexedVolume> whole;
  std::shared_ptr<const volume::LevelGaps> gaps;  // of `isovalues`
  std::vector<double> isovalues;
};

struct StructureSubject {
  std::shared_ptr<const volume::PreparedVolume> volume;  // the level
  scene::Scene scene;                                    // resolved, as it is shown in motion
  std::function<render::ColorImage()> picture;           // copied out on the thread
  std::optional<render::Tile> taken;                     // by the picture's own legend
  KnownStructure known;
};
struct FoundStructure {
  std::optional<HiddenStructure> structure;  // none: the volume has no index
  MarkedPicture marked;
  KnownStructure known;
};
using StructureTask = base::Task<FoundStructure>;
std::unique_ptr<StructureTask> structureTask(StructureSubject asked);

}  // namespace isolux::app
