// A volume's file, opened once: its voxels stay in it and are read in parts, or they are read whole.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/bricks/chunked_volume.h"
#include "volume/read/reader.h"

namespace isolux::volume {

struct VolumeFile {
  std::shared_ptr<const ChunkedVolume> parts;  // null: only the whole can be read
  std::string whyWhole;                        // one line, if `parts` is null
  // Returns what readVolume() returns and throws what it throws. `options` may differ from those at opening
  // in all but the raw description and the series.
  std::function<Volume(const ReadOptions& options, base::Progress& progress)> readWhole;
};

// Parses the header and looks up where the voxels are. Formats that another process decodes, unknown ones,
// meshes and phantoms are first read by readWhole(). Throws as readVolume().
VolumeFile openVolume(const std::string& path, const ReadOptions& options, base::Progress& progress);

// Opens the one file of `source`. `parts` is also null for a magnitude and for the combination with a second
// volume. If steps are blended or are files of their own, nothing is opened and `readWhole` is empty. Throws
// as readVolume(); {usage} if `parts` lacks the channel or time step.
VolumeFile openSource(const scene::Source& source, base::Progress& progress);

}  // namespace isolux::volume
