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
  const volume::Extent3 extent{lattice.dims};
  const int z = layer * kBlockTexels, slices = std::min(kBlockTexels, lattice.dims.z - z);
  return {extent.index(0, 0, z), extent.slice() * static_cast<std::size_t>(slices)};
}

// Calls visit(block, index in the block, index in the layer) for each texel of a layer, block by block.
template <class Visit>
void forEachTexelOfLayer(const LatticeGeometry& lattice, int layer, Visit visit) {
  const std::uint64_t from = layerOf(lattice, layer).first;
  const auto perLayer = static_cast<std::uint32_t>(volume::Extent3{lattice.blockDims()}.slice());
  const auto begin = static_cast<std::uint32_t>(layer) * perLayer;
  for (std::uint32_t block = begin; block < begin + perLayer; ++block)
    for (int i = 0; i < kTexelsOfBlock; ++i) {
      const glm::ivec3 texel = lattice.texelOf(block, i);
      if (lattice.contains(texel))
        visit(block, static_cast<std::size_t>(i), static_cast<std::size_t>(lattice.indexOf(texel) - from));
    }
}

}  // namespace isolux::gi
