// The cells of a block of 8x8x8, with their corners: how deep each voxel lies inside, and which cells an
// isosurface crosses, 64 at once.
//
// A block has 9x9x9 corners, those of its last cells being the next block's. Along an axis of one voxel there
// is one cell with that voxel at both ends, so that a single slice has the connectivity of its faces.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "volume/pieces/block_voxels.h"
#include "volume/skip/row_lanes.h"
#include "volume/visible/inside_level.h"

namespace isolux::volume {

inline glm::ivec3 cellsOf(glm::ivec3 voxels) {
  return glm::max(voxels - 1, glm::ivec3(1));
}

class BlockCells {
 public:
  // Bits x + 8 y of the cells of one slice.
  struct Slice {
    std::array<std::uint64_t, 8> corners;  // inside, of each corner x + 2 y + 4 z
    std::uint64_t cells = 0;               // that there are
    std::uint64_t crossed = 0;             // with corners on both sides
    std::uint64_t whole = 0;               // with all corners inside
    // Whose inside corners do not all hang together along the cell's edges.
    std::uint64_t ambiguous() const;
  };

  template <class T>
  void load(const std::vector<T>& voxels, glm::ivec3 dims, glm::ivec3 block, InsideLevel level);

  glm::ivec3 count() const { return count_; }
  Slice slice(int z) const;
  // NaN where missing.
  float depth(glm::ivec3 corner) const {
    return depth_[at(corner.y, corner.z) + static_cast<std::size_t>(corner.x)];
  }
  std::array<float, 8> depths(glm::ivec3 cell) const {
    std::array<float, 8> result;
    for (int corner = 0; corner < 8; ++corner)
      result[static_cast<std::size_t>(corner)] =
          depth(cell + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2));
    return result;
  }

 private:
  static constexpr int kCorners = kPieceBlock + 1;
  static std::size_t at(int y, int z) { return static_cast<std::size_t>((z * kCorners + y) * kCorners); }

  glm::ivec3 count_{0};  // of cells, at most 8 per axis
  std::array<float, std::size_t{kCorners} * kCorners * kCorners> depth_;
  // Which corners of a layer z = const are inside: x and y below 8 as in VoxelBits; those at x = 8 (bit 8 y)
  // and at y = 8 (bit x).
  struct Layer {
    std::uint64_t bits = 0, lastX = 0;
    unsigned lastY = 0;
    std::array<std::uint64_t, 4> shifted() const;  // of the corners x + 2 y of each cell
  };
  std::array<Layer, kCorners> layers_;
};

template <class T>
void BlockCells::load(const std::vector<T>& voxels, glm::ivec3 dims, glm::ivec3 block, InsideLevel level) {
  const glm::ivec3 first = block * kPieceBlock;
  count_ = glm::min(cellsOf(dims) - first, kPieceBlock);
  if (glm::any(glm::lessThanEqual(count_, glm::ivec3(0)))) {
    count_ = glm::ivec3(0);
    return;
  }
  const float sign = level.high ? 1.0f : -1.0f;
  for (int z = 0; z <= count_.z; ++z) {
    Layer& layer = layers_[static_cast<std::size_t>(z)] = {};
    for (int y = 0; y <= count_.y; ++y) {
      const auto inY = static_cast<std::size_t>(std::min(first.y + y, dims.y - 1)),
                 inZ = static_cast<std::size_t>(std::min(first.z + z, dims.z - 1));
      const T* const row =
          voxels.data() + (inZ * static_cast<std::size_t>(dims.y) + inY) * static_cast<std::size_t>(dims.x);
      float* const depth = &depth_[at(y, z)];
      unsigned bits = 0;
      int x = 0;
      if (count_.x == kPieceBlock) {
        const FourFloats near = sign * (fourOf(row + first.x) - level.level),
                         far = sign * (fourOf(row + first.x + 4) - level.level);
        std::memcpy(depth, &near, sizeof near);
        std::memcpy(depth + 4, &far, sizeof far);
        bits = eightBits(near >= 0.0f, far >= 0.0f);
        x = kPieceBlock;
      }
      for (; x <= count_.x; ++x) {
        depth[x] = sign * (static_cast<float>(row[std::min(first.x + x, dims.x - 1)]) - level.level);
        bits |= static_cast<unsigned>(depth[x] >= 0.0f) << x;
      }
      if (y == kPieceBlock) {
        layer.lastY = bits;
      } else {
        layer.bits |= std::uint64_t{bits & 255u} << (8 * y);
        layer.lastX |= std::uint64_t{bits >> 8} << (8 * y);
      }
    }
  }
}

}  // namespace isolux::volume
