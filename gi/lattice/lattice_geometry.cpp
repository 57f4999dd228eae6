#include "gi/lattice/lattice_geometry.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "gi/lattice/texel_bits.h"

namespace isolux::gi {

LatticeGeometry LatticeGeometry::make(glm::ivec3 volumeDims, double scale, std::optional<float> isovalue) {
  LatticeGeometry lattice;
  lattice.volumeDims = volumeDims;
  lattice.isovalue = isovalue;
  for (int a = 0; a < 3; ++a)
    lattice.dims[a] = static_cast<int>(std::max(std::lround((volumeDims[a] - 1) * scale), 0L)) + 1;
  return lattice;
}

glm::dvec3 LatticeGeometry::voxelsPerTexel() const {
  glm::dvec3 voxels(0.0);
  for (int a = 0; a < 3; ++a)
    if (dims[a] > 1) voxels[a] = static_cast<double>(volumeDims[a] - 1) / (dims[a] - 1);
  return voxels;
}

glm::vec3 LatticeGeometry::reach() const {
  glm::vec3 voxels(voxelsPerTexel());
  for (int a = 0; a < 3; ++a)
    if (dims[a] == 1) voxels[a] = static_cast<float>(volumeDims[a] - 1);
  return voxels;
}

glm::vec3 LatticeGeometry::voxelOf(glm::ivec3 texel) const {
  // The product first: exact where a texel lies on a voxel.
  glm::vec3 voxel(0.0f);
  for (int a = 0; a < 3; ++a)
    if (dims[a] > 1)
      voxel[a] = static_cast<float>(static_cast<double>(texel[a]) * (volumeDims[a] - 1) / (dims[a] - 1));
  return voxel;
}

glm::dvec3 LatticeGeometry::texelOf(glm::dvec3 voxel) const {
  glm::dvec3 texel(0.0);
  for (int a = 0; a < 3; ++a)
    if (dims[a] > 1 && volumeDims[a] > 1) texel[a] = voxel[a] * (dims[a] - 1) / (volumeDims[a] - 1);
  return texel;
}

std::uint32_t LatticeGeometry::blockCount() const {
  return static_cast<std::uint32_t>(volume::Extent3{blockDims()}.count());
}

std::uint32_t LatticeGeometry::blockOf(glm::ivec3 texel) const {
  assert(contains(texel));
  return static_cast<std::uint32_t>(volume::Extent3{blockDims()}.index(texel / kBlockTexels));
}

glm::ivec3 LatticeGeometry::firstTexelOf(std::uint32_t block) const {
  const glm::ivec3 blocks = blockDims();  // divisions of 32 bits: bakes ask often
  const auto nx = static_cast<std::uint32_t>(blocks.x), ny = static_cast<std::uint32_t>(blocks.y);
  return kBlockTexels * glm::ivec3(static_cast<int>(block % nx), static_cast<int>(block / nx % ny),
                                   static_cast<int>(block / nx / ny));
}

int LatticeGeometry::indexInBlock(glm::ivec3 texel) {
  const auto within = [](int t) { return t & (kBlockTexels - 1); };
  return (within(texel.z) * kBlockTexels + within(texel.y)) * kBlockTexels + within(texel.x);
}

glm::ivec3 LatticeGeometry::texelOf(std::uint32_t block, int index) const {
  return firstTexelOf(block) + glm::ivec3(index % kBlockTexels, index / kBlockTexels % kBlockTexels,
                                          index / (kBlockTexels * kBlockTexels));
}

std::uint64_t LatticeGeometry::indexOf(glm::ivec3 texel) const {
  assert(contains(texel));
  return volume::Extent3{dims}.index(texel);
}

std::bitset<kTexelsOfBlock> texelsWithin(const LatticeGeometry& lattice, std::uint32_t block) {
  std::bitset<kTexelsOfBlock> within;
  const glm::ivec3 last = lattice.firstTexelOf(block) + (kBlockTexels - 1);
  if (lattice.contains(last)) return within.set();
  for (int i = 0; i < kTexelsOfBlock; ++i)
    within[static_cast<std::size_t>(i)] = lattice.contains(lattice.texelOf(block, i));
  return within;
}

}  // namespace isolux::gi
