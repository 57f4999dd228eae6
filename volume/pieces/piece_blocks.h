// Every block of 8x8x8 voxels at one isovalue: outside, inside, or mixed with its components; and the numbers
// of all these components, the nodes that pieces are joined from.
//
// MinMaxBlocks tell of most blocks what they are without a look at their voxels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "base/memory_budget.h"
#include "base/progress.h"
#include "volume/pieces/block_voxels.h"
#include "volume/skip/min_max_blocks.h"
#include "volume/visible/inside_level.h"

namespace isolux::volume {

// Of what grows with the pieces. Throws Error{memory}.
base::MemoryBudget::Held reserveForPieces(std::size_t bytes);

class PieceBlocks {
 public:
  static constexpr std::uint32_t kNoLabel = 0xffffffffu;

  // Multithreaded; throws Error: interrupted, memory.
  PieceBlocks(const Grid& grid, const MinMaxBlocks& blocks, InsideLevel level, base::Progress& progress);

  glm::ivec3 dims() const { return dims_; }  // in blocks
  glm::ivec3 voxelDims() const { return voxelDims_; }
  std::size_t index(glm::ivec3 block) const { return Extent3{dims_}.index(block); }
  std::uint32_t nodes() const { return nodes_; }
  std::size_t bytes() const;

  // What a block holds; nothing of it is owned.
  struct View {
    std::uint32_t firstNode = kNoLabel;  // none: outside
    int components = 0;
    const VoxelBits* bits = nullptr;  // of a block that is inside as a whole: all set, beyond the border too
    const VoxelLabels* labels = nullptr;  // none: one component
    std::uint32_t labelOf(glm::ivec3 voxelInBlock) const {
      if (!labels) return firstNode;
      const auto at = glm::uvec3(voxelInBlock);
      return firstNode + (*labels)[at.x + 8U * at.y + 64U * at.z];
    }
  };
  View view(glm::ivec3 block) const;
  bool mixed(std::size_t block) const { return blocks_[block].mixed >= 0; }
  bool inside(std::size_t block) const { return blocks_[block].mixed == kInside; }

  // kNoLabel: outside.
  std::uint32_t labelOf(glm::ivec3 voxel) const {
    const View block = view(voxel / kPieceBlock);
    const glm::ivec3 in = voxel % kPieceBlock;
    return block.bits && bitAt(*block.bits, in) ? block.labelOf(in) : kNoLabel;
  }

  // Whether the cells whose lowest corners are this block's voxels can have corners on both sides.
  bool crossed(std::size_t block) const { return crossed_[block] != 0; }

 private:
  static constexpr std::int32_t kOutside = -1, kInside = -2;
  struct Block {
    std::uint32_t firstNode = kNoLabel;
    std::int32_t mixed = kOutside;  // or kInside, or where in its row
  };
  struct Mixed {
    VoxelBits bits;
    std::int32_t labels = -1;  // where in its row; -1: one component
    std::int32_t components = 1;
  };
  struct Row {  // of blocks along x
    std::vector<Mixed> mixed;
    std::vector<VoxelLabels> labels;
    std::uint32_t nodes = 0;
  };

  template <class T>
  void fillRow(const std::vector<T>& voxels, const MinMaxBlocks& bounds, bool anyMissing, std::size_t row);
  template <class T>
  VoxelBits read(const std::vector<T>& voxels, glm::ivec3 block) const;
  void classify(const VoxelBits& bits, glm::ivec3 block, Block& result, Row& row);
  std::uint64_t fullWord(glm::ivec3 block) const;  // of a slice within the border
  void numberNodes();

  InsideLevel level_;
  glm::ivec3 voxelDims_, dims_;
  std::vector<Block> blocks_;
  std::vector<std::uint8_t> crossed_;
  std::vector<Row> rows_;
  std::uint32_t nodes_ = 0;
  base::MemoryBudget::Held held_;
};

}  // namespace isolux::volume
