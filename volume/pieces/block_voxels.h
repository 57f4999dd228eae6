// The voxels of a block of 8x8x8 voxels as bits, one where a voxel is inside, and their connected components
// along axes.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include <glm/vec3.hpp>

namespace isolux::volume {

inline constexpr int kPieceBlock = 8;  // voxels per axis

// Bit x + 8 y of word z is voxel (x, y, z).
using VoxelBits = std::array<std::uint64_t, 8>;
// Of each voxel that is inside its component; voxel x + 8 y + 64 z.
using VoxelLabels = std::array<std::uint8_t, 512>;

inline bool bitAt(const VoxelBits& bits, glm::ivec3 voxel) {
  return (bits[static_cast<std::size_t>(voxel.z)] >> (voxel.x + 8 * voxel.y) & 1u) != 0;
}

// Components of the set bits, numbered from 0 by their first voxels in the order of memory; at most 256.
// `labels` is written where there are at least two. Returns how many.
int labelVoxels(const VoxelBits& bits, VoxelLabels& labels);

}  // namespace isolux::volume
