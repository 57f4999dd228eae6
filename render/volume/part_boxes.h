// Of a volume that stays in its file, which boxes of its resident bricks an isosurface can cross
// (volume/skip/box_bounds.h): made of a brick's voxels when it comes, 16 KiB each.
//
// Of bricks that have not come every box of an active block may hold a surface. A ray that has its answer has
// waited for each brick in which it came to such a box, so it has stepped over the boxes that it steps over
// in memory, and its hit is the same, bit for bit.
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
  // Bricks are those of brick_cache.h; blocks have 8 cells per axis.
  explicit PartBoxes(std::shared_ptr<const volume::Grid> grid);

  // The brick is on the graphics card from now on, or no longer. Of its lost blocks any box may hold a
  // surface. Throws base::Error{memory}.
  void moved(glm::ivec3 brick, bool isResident, BlockBits lost = 0);
  void clear() { boxes_.clear(); }

  // A box of blocks, x fastest.
  struct Blocks {
    glm::ivec3 low, size;
    std::vector<std::uint64_t> masks;  // BoxBounds::masks()
  };
  // Of a resident brick, for surfaces of these values as blocks hold them; of another one: no blocks.
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
