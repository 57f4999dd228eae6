// Defines the positions of a light lattice's texels, and their grouping in blocks.
//
// Texels per axis: round((n - 1) * scale) + 1 for n voxels, at least 1. Texel 0 is at voxel 0 and the last at
// the last voxel, evenly spaced between: at scale 1 each texel is at a voxel. Blocks are 8x8x8 texels; those
// at the upper border may be partly outside. x varies fastest in indices of texels, within blocks, and of
// blocks.
//
// A texel is lit on the isosurface through it. If the lattice has an isovalue, a texel is lit at the point of
// that isosurface nearest to it. Such a lattice serves one isovalue, with a smaller error.
#pragma once

#include <cstdint>
#include <optional>

#include <glm/vec3.hpp>

#include "volume/voxels/extent.h"

namespace isolux::gi {

inline constexpr int kBlockTexels = 8;  // per axis
inline constexpr int kTexelsOfBlock = kBlockTexels * kBlockTexels * kBlockTexels;

struct LatticeGeometry {
  glm::ivec3 dims{0};               // texels
  glm::ivec3 volumeDims{0};         // voxels
  std::optional<float> isovalue{};  // stored units; nullopt: each texel has its own

  static LatticeGeometry make(glm::ivec3 volumeDims, double scale,
                              std::optional<float> isovalue = std::nullopt);

  glm::dvec3 voxelsPerTexel() const;  // per axis; 0 on an axis of one texel
  glm::vec3 reach() const;  // voxels: how far a lookup (of 2 texels per axis) may be from a texel it reads
  glm::vec3 voxelOf(glm::ivec3 texel) const;
  glm::dvec3 texelOf(glm::dvec3 voxel) const;  // continuous; 0 on an axis of one texel
  bool contains(glm::ivec3 texel) const { return volume::Extent3{dims}.contains(texel); }

  glm::ivec3 blockDims() const { return (dims + (kBlockTexels - 1)) / kBlockTexels; }
  std::uint32_t blockCount() const;
  std::uint32_t blockOf(glm::ivec3 texel) const;       // index of the block
  glm::ivec3 firstTexelOf(std::uint32_t block) const;  // its lowest corner
  static int indexInBlock(glm::ivec3 texel);           // 0 .. 511
  glm::ivec3 texelOf(std::uint32_t block, int index) const;
  std::uint64_t indexOf(glm::ivec3 texel) const;  // in the whole lattice

  bool operator==(const LatticeGeometry&) const = default;
};

}  // namespace isolux::gi
