// Opens the file of a source so that parts of it can be read.
#pragma once

#include <memory>
#include <string>

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/bricks/chunked_volume.h"

namespace isolux::volume {

// Null, with one line why, where only the whole can be read: another format, packed voxels, a magnitude, the
// combination with a second volume. Throws base::Error: input, where the file is damaged; usage, where it has
// no such component or time step.
std::shared_ptr<const ChunkedVolume> openChunked(const scene::Source& source, std::string& reason,
                                                 base::Progress& progress);

// Whether it can be opened so.
bool isReadInParts(const scene::Source& source, base::Progress& progress);

}  // namespace isolux::volume
