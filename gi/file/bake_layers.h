// Enumerates layers of blocks as plain arrays, for files: texels of 8 slices, x fastest, components
// interleaved.
#pragma once

#include <algorithm>
#include <cstdint>

#include "gi/lattice/lattice_geometry.h"

namespace isolux::gi {

inline int layersOf(const LatticeGeometry& lattice) {
  return lattice.blockDims().z;
}

// The texels [first, first + count) of the whole lattice.
struct Layer {
  std::uint64_t first = 0;
  std::size_t count = 0;
};
inline Layer layerOf(const LatticeGeometry& lattice, int layer) {
  const glm::ivec3 d = lattice.dims;
  const std::uint64_t slice = static_cast<std::uint64_t>(d.x) * static_cast<std::uint64_t>(d.y);
  const int z = layer * kBlockTexels;
  return {slice * static_cast<std::uint64_t>(z),
          static_cast<std::size_t>(slice) * static_cast<std::size_t>(std::min(kBlockTexels, d.z - z))};
}

// Calls visit(block, index in the block, index in the layer) for each texel of a layer, block by block.
template <class Visit>
void forEachTexelOfLayer(const LatticeGeometry& lattice, int layer, Visit visit) {
  const glm::ivec3 blocks = lattice.blockDims();
  const std::uint64_t from = layerOf(lattice, layer).first;
  const auto perLayer = static_cast<std::uint32_t>(blocks.x) * static_cast<std::uint32_t>(blocks.y);
  const auto begin = static_cast<std::uint32_t>(layer) * perLayer;
  for (std::uint32_t block = begin; block < begin + perLayer; ++block)
    for (int i = 0; i < kTexelsOfBlock; ++i) {
      const glm::ivec3 texel = lattice.texelOf(block, i);
      if (lattice.contains(texel))
        visit(block, static_cast<std::size_t>(i), static_cast<std::size_t>(lattice.indexOf(texel) - from));
    }
}

}  // namespace isolux::gi
