// The voxels of a level: those of one of the file's own levels, or means of them, made while it is read.
// Beside the level and the chunks in hand nothing is in memory.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "volume/bricks/chunked_volume.h"
#include "volume/bricks/damage.h"
#include "volume/voxels/grid_geometry.h"

namespace isolux::volume {

// The file's level that a level is made of, and how many of its voxels make one.
struct LevelOrigin {
  std::size_t fileLevel = 0;
  glm::ivec3 factor{1};
};

struct LevelVoxels {
  VoxelArray voxels;
  std::vector<DamagedPart> damaged;  // voxels of the file's level, in the order in which they lie there
  // Voxels of which nothing could be read, ascending; only where the type has none that are missing: 0 there.
  std::vector<std::size_t> unknown;
};

// Of `dims` voxels: the origin's, in its voxels at least one of each. Means are rounded to the stored type;
// missing voxels do not count, and a mean of missing ones alone is missing; at the far borders the last
// voxels repeat. around: what cannot be read counts as missing; otherwise it throws Error{input}. Throws
// Error: memory, interrupted; input, where more than kMostDamagedParts cannot be read.
LevelVoxels readLevelVoxels(const ChunkedVolume& file, VolumePart part, const LevelOrigin& origin,
                            glm::ivec3 dims, bool around, base::Progress& progress);

// Its voxels as float32, the unknown ones missing.
std::vector<float> withMissing(const LevelVoxels& level, base::Progress& progress);

}  // namespace isolux::volume
