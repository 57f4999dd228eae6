// Checks which parts of a scene cannot be drawn for an out-of-core volume (memory.voxels).
#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"

namespace isolux::scene {

// Returns one line: the first feature that needs all voxels in memory, and the setting to use instead.
// Returns nullopt if the whole scene can be drawn. Scales of `resolved` derivatives count if they are known.
std::optional<std::string> needsWholeVoxels(const Scene& resolved);

}  // namespace isolux::scene
