// A picture of a volume that is still being read (volume/large/volume_preview.h), for whoever waits for it.
#pragma once

#include <memory>
#include <optional>

#include "base/task.h"
#include "render/graph/frame.h"
#include "scene/scene.h"
#include "volume/large/volume_preview.h"

namespace isolux::app {

struct VolumePreviewSubject {
  scene::Scene scene;  // that will be shown: its look, and its view where it has one
  glm::ivec2 size{0};  // pixels
  double pixelRatio = 1.0;
  std::size_t least = volume::kPreviewLeastBytes;
};
struct DrawnVolumePreview {
  render::ColorImage picture;
  glm::ivec3 step{1};      // voxels of the volume from one that is seen to the next
  bool fromIndex = false;  // boxes of so many voxels are seen
};
// Its value: none where there is no preview. Its thread gives way to nobody: it is awaited.
using VolumePreviewTask = base::Task<std::optional<DrawnVolumePreview>>;
std::unique_ptr<VolumePreviewTask> volumePreviewTask(VolumePreviewSubject asked);

}  // namespace isolux::app
