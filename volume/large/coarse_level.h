// Coarser levels of a volume that can be read in parts: an overview of what does not fit in memory.
//
// Level 0 is the file's voxels; level n those of the file's own level n, or, where it has fewer, the means of
// 2 voxels of what is below along each axis, as many times as are missing; an axis of which fewer than 8
// voxels would be left stays as it is (volume/bricks/level_voxels.h).
#pragma once

#include <cstddef>
#include <string>

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/bricks/chunked_volume.h"
#include "volume/read/volume_file.h"
#include "volume/volume.h"

namespace isolux::volume {

// What a level's voxels take in memory while they are read, with the bounds of boxes that pictures skip space
// by.
std::size_t levelBytes(const ChunkedFacts& facts, int level);

// The finest level of the volume, from `finest` on, that fits into what the machine's memory budget has left:
// 0 where the volume itself does, or where it cannot be read in parts; the coarsest where none fits. share:
// of what is left, that a coarser level may take.
int levelThatFits(const VolumeFile& file, int finest = 0, double share = 1.0);

// `source`, whose file is open, at its level, 0 included, as readVolume(); the first warnings are what could
// not be read (Source::aroundDamage) and what the level hides. Throws base::Error: usage where it has no such
// level or cannot be read in parts, memory, input (also where nothing can be read), interrupted.
Volume readLevel(const VolumeFile& file, const scene::Source& source, base::Progress& progress);

}  // namespace isolux::volume
