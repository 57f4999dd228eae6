// Where a coarser level of a volume (volume/large/coarse_level.h) may hide a surface.
//
// A gap is a block of 8^3 cells of the volume's own voxels that an isovalue crosses, while the level's
// trilinear field stays on one side of it over the same box. Blocks are those of the volume's index; the
// level's field is bounded by its voxels around the box. A surface that the level shows, but up to one of its
// voxels elsewhere, is no gap.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/grid.h"
#include "volume/hit/cell_walk.h"
#include "volume/skip/min_max_blocks.h"

namespace isolux::volume {

// Level 0 by its index: stored units.
struct IndexedVolume {
  GridGeometry geometry;
  std::shared_ptr<const MinMaxBlocks> blocks;
};
// Of the volume of which `source` reads a level. Nothing where it has no index as it is now
// (IndexFile::find). Throws base::Error: input, usage, as openSource().
std::optional<IndexedVolume> indexedVolume(scene::Source source, base::Progress& progress);

class LostStructure {
 public:
  // level: grid of a level, of the same stored units as the index. isovalues: data units. Multithreaded;
  // throws Error{interrupted}.
  LostStructure(const IndexedVolume& whole, const Grid& level, std::span<const double> isovalues,
                base::Progress& progress);

  std::size_t count() const { return count_; }
  // Whether a ray, in voxel coordinates of level 0, passes a gap.
  bool on(const Ray& ray) const;

 private:
  glm::ivec3 dims_;  // voxels of level 0
  std::shared_ptr<const MinMaxBlocks> blocks_;
  std::vector<std::uint8_t> gaps_;  // of each block
  std::size_t count_ = 0;
};

}  // namespace isolux::volume
