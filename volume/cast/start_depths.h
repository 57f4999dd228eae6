// Where the rays of each tile of pixels can meet a surface: from where the first block that may hold one
// begins to where the last one ends, along the view direction. By projecting the blocks (object order),
// conservatively: no ray meets a surface outside of its tile's depths.
//
// Hadwiger et al. 2005 sec. 3.1 rasterises the blocks' faces for this; a tile needs less and costs less.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "volume/cast/picture_rays.h"
#include "volume/voxels/extent.h"

namespace isolux::volume {

struct StartDepths {
  static constexpr int kTile = 4;  // pixels: of the packets of SurfaceCaster
  struct Depths {
    float first, last;  // mm along the view direction from `eye`; first > last: no block
  };
  glm::ivec2 tiles{0};
  std::vector<Depths> depths;  // x fastest

  const Depths& at(int tileX, int tileY) const { return depths[Extent2{tiles}.index(tileX, tileY)]; }
};

// The blocks of a volume.
struct BlockMasks {
  glm::ivec3 blocks;
  std::span<const std::uint64_t> masks;  // x fastest; 0: it holds nothing
  int blockCells = 8;
};

// size: pixels that are cast; tile: pixels per tile and axis.
StartDepths startDepths(const PictureRays& rays, glm::ivec2 size, glm::ivec3 voxels, const BlockMasks& of,
                        int tile = StartDepths::kTile);

}  // namespace isolux::volume
