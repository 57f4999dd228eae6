// Provides the sub-blocks of resident bricks that an isosurface can cross (volume/skip/box_bounds.h), for an
// out-of-core volume. They are computed from a brick's voxels when it is loaded, 16 KiB each.
//
// In bricks that are not loaded, every sub-block of an active block may contain a surface. A ray with a
// result has waited for each brick in which it reached such a sub-block. It has therefore skipped the same
// sub-blocks as in memory, and its hit is bit-identical.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <tuple>
#include <vector>

#include <glm/vec3.hpp>

#include "render/volume/brick_cache.h"
#include "volume/grid.h"
#include "volume/skip/active_blocks.h"
#include "volume/skip/box_bounds.h"

namespace isolux::render {

class PartBoxes {
 public:
  // Uses the bricks of brick_cache.h; blocks have 8 cells per axis.
  explicit PartBoxes(std::shared_ptr<const volume::Grid> grid);

  // Records that the brick is now on the GPU, or no longer. Any sub-block of its lost blocks may contain a
  // surface. Throws base::Error{memory}.
  void moved(glm::ivec3 brick, bool isResident, BlockBits lost = 0);
  void clear() { boxes_.clear(); }

  // A box of blocks, x fastest.
  struct Blocks {
    glm::ivec3 low, size;
    std::vector<std::uint64_t> masks;  // BoxBounds::masks()
  };
  // Returns the masks of a resident brick for surfaces of these values, in the blocks' units; no blocks if it
  // is not resident.
  Blocks masks(glm::ivec3 brick, std::span<const float> storedIsovalues,
               const volume::ActiveBlocks& active) const;
  std::vector<glm::ivec3> resident() const;

 private:
  struct Before {
    bool operator()(glm::ivec3 a, glm::ivec3 b) const {
      return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
    }
  };
  std::shared_ptr<const volume::Grid> grid_;
  struct Known {
    volume::BoxBounds boxes;
    BlockBits lost = 0;
  };
  std::map<glm::ivec3, Known, Before> boxes_;
};

}  // namespace isolux::render
