// Coarser levels of a volume that can be read in parts: an overview of what does not fit in memory.
//
// Level 0 is the file's voxels; level n those of the file's own level n, or, where it has fewer, the means of
// 2 x 2 x 2 voxels of what is below, as many times as are missing. Means are rounded to the stored type;
// missing voxels do not count, and a mean of missing voxels alone is missing. At the far borders the last
// voxels repeat.
#pragma once

#include <cstddef>
#include <string>

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/bricks/chunked_volume.h"
#include "volume/read/reader.h"

namespace isolux::volume {

// Of no axis is less left than 8 voxels that has more in the file.
int coarsestLevel(const ChunkedFacts& facts);
// 0 <= level <= coarsestLevel().
GridGeometry levelGeometry(const ChunkedFacts& facts, int level);
// Of a level's voxels in memory, with the bounds of boxes that pictures skip space by.
std::size_t levelBytes(const ChunkedFacts& facts, int level);

// What level is missing and what that hides, in a sentence.
std::string levelNote(const ChunkedFacts& facts, int level);

// The finest level of `source` that fits into what the machine's memory budget has left: 0 where the volume
// itself does, or where it cannot be read in parts; the coarsest where none fits. Errors of opening it count
// as 0: whoever reads it is told.
int levelThatFits(const scene::Source& source, base::Progress& progress);

// `source` at its level, as readVolume(); levelNote() is its first warning. Throws base::Error: usage where
// it has no such level or cannot be read in parts, memory, input, interrupted.
Volume readLevel(const scene::Source& source, base::Progress& progress);

}  // namespace isolux::volume
