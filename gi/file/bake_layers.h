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

inline std::uint32_t blocksPerLayer(const LatticeGeometry& lattice) {
  return static_cast<std::uint32_t>(volume::Extent3{lattice.blockDims()}.slice());
}
inline std::size_t texelsOfLayer(const LatticeGeometry& lattice, int layer) {
  const int slices = std::min(kBlockTexels, lattice.dims.z - layer * kBlockTexels);
  return volume::Extent3{lattice.dims}.slice() * static_cast<std::size_t>(slices);
}

// Calls visit(index in the block, index in its layer) for each texel of a block.
template <class Visit>
void forEachTexelOfBlock(const LatticeGeometry& lattice, std::uint32_t block, Visit visit) {
  const std::uint64_t from = volume::Extent3{lattice.dims}.index(0, 0, lattice.texelOf(block, 0).z);
  for (int i = 0; i < kTexelsOfBlock; ++i) {
    const glm::ivec3 texel = lattice.texelOf(block, i);
    if (lattice.contains(texel))
      visit(static_cast<std::size_t>(i), static_cast<std::size_t>(lattice.indexOf(texel) - from));
  }
}

}  // namespace isolux::gi
