// What of a scene cannot be drawn of a volume whose voxels stay in its file (memory.voxels).
#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"

namespace isolux::scene {

// The first thing that needs all voxels in memory, and what to set instead: one line; nothing: all of the
// scene can be drawn. `resolved` derivatives' scales count where they are known.
std::optional<std::string> needsWholeVoxels(const Scene& resolved);

}  // namespace isolux::scene
