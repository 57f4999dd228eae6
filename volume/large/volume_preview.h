// A first look at a large volume, long before it is read: some of its voxels, in about a second.
//
// Of a file with coarser levels the finest of at most so many voxels; else every n-th voxel along each axis,
// where parts of it cost no more than those parts; else, where the volume has an index (index_file.h), the
// middle between the least and the greatest value of boxes of blocks. Single voxels are no means: what lies
// between them is not seen, and noise stays. It is for the eye while somebody waits, not for measures.
#pragma once

#include <cstddef>
#include <optional>

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/volume.h"

namespace isolux::volume {

inline constexpr int kPreviewAxis = 96;                                    // samples of an axis, about
inline constexpr std::size_t kPreviewVoxels = std::size_t{4} << 20;        // of a level of the file
inline constexpr std::size_t kPreviewLeastBytes = std::size_t{256} << 20;  // smaller volumes are read as soon

// Its voxels as a volume, in the place of the whole. Nothing: it is small, or cannot be had soon. `least`:
// bytes of a volume that is not small; `most`: voxels of a level, or of what is made of the index. Throws
// base::Error as openSource(), and what reading throws.
struct VolumePreview {
  Volume volume;
  glm::ivec3 step{1};      // voxels of level 0 from one to the next
  bool fromIndex = false;  // of boxes of `step` voxels
};
std::optional<VolumePreview> readVolumePreview(const scene::Source& source, base::Progress& progress,
                                               std::size_t least = kPreviewLeastBytes,
                                               std::size_t most = kPreviewVoxels);

}  // namespace isolux::volume
