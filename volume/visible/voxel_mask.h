// Voxels of an isosurface's inside whose pieces are not shown: what rays see as inside is inside and not
// hidden.
//
// For one isovalue and one side. A cell whose inside corners are all hidden holds no surface. In a cell that
// has both, a crossing is of the piece of the corner that one comes to by going, per axis in turn, to the end
// of the cell where the field is further inside: that path does not leave the inside.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "volume/voxels/extent.h"

namespace isolux::volume {

class VoxelMask {
 public:
  static constexpr int kVoxelsPerWord = 64;

  // No voxel is hidden. One bit a voxel. hidesStrays: whether what a spline has of the surface where no voxel
  // around is inside, which belongs to no piece, is hidden.
  explicit VoxelMask(glm::ivec3 dims, bool hidesStrays = false);

  // `voxel` within dims.
  bool at(glm::ivec3 voxel) const { return (words_[word(voxel)] >> (voxel.x % kVoxelsPerWord) & 1u) != 0; }
  // Voxels x from `begin` to before `end` of row (y, z).
  void hide(int begin, int end, int y, int z);
  bool any() const { return any_; }
  bool hidesStrays() const { return hidesStrays_; }

  glm::ivec3 dims() const { return dims_; }
  // Bit x % 64 of word x / 64 + wordsPerRow (y + dims.y z).
  int wordsPerRow() const { return wordsPerRow_; }
  std::span<const std::uint64_t> words() const { return words_; }
  // Equal where the same voxels are hidden, in all likelihood otherwise not; 0 where none is.
  std::uint64_t key() const;

 private:
  std::size_t word(glm::ivec3 voxel) const {
    return Extent3{{wordsPerRow_, dims_.y, dims_.z}}.index(voxel.x / kVoxelsPerWord, voxel.y, voxel.z);
  }

  glm::ivec3 dims_;
  bool hidesStrays_, any_ = false;
  int wordsPerRow_;
  std::vector<std::uint64_t> words_;
};

}  // namespace isolux::volume
