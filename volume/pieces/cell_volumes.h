// How much of the inside the cells of a block enclose, added up by the components (nodes) of blocks: what
// sizes of pieces are made of.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "volume/hit/bernstein_cubic.h"
#include "volume/pieces/block_cells.h"
#include "volume/pieces/piece_blocks.h"
#include "volume/pieces/running_sums.h"

namespace isolux::volume {

// The part of a cell in which f >= 0: the mean of 4 x 4 columns along x, along which f is linear. Exact where
// every column is crossed and the length inside changes linearly from one to the next.
float partInside(const std::array<float, 8>& depths);

// The same in parts, each of the piece of a corner: what the columns hold that lead to it (cornerAbove).
std::array<double, 8> cornerShares(const CellCorners& values);

// Of each node, 2^-32 cells: integers, so that the sums are the same in whatever order.
using NodeVolumes = std::vector<std::uint64_t>;
inline constexpr double kVolumeUnits = 4294967296.0;  // of a cell

// Adds cells of a row of blocks; several threads may each have one for the same volumes.
class CellVolumes {
 public:
  CellVolumes(const PieceBlocks& blocks, bool anyMissing, NodeVolumes& volumes)
      : blocks_(blocks), anyMissing_(anyMissing), volumes_(volumes) {}

  // A block whose cells are all whole, or all empty.
  void addUncrossed(glm::ivec3 block);
  // Slice z of a crossed one. `ambiguous`: of the slice.
  void addSlice(glm::ivec3 block, const BlockCells& cells, const BlockCells::Slice& slice, int z,
                std::uint64_t ambiguous);

 private:
  void addWhole(const PieceBlocks::View& view, std::uint64_t whole, int z);
  void addCrossed(glm::ivec3 block, const PieceBlocks::View& view, const BlockCells& cells, int corner,
                  std::uint64_t crossed, int z);
  void addAmbiguous(glm::ivec3 cell, const std::array<float, 8>& depths);
  bool hasMissing(const std::array<float, 8>& depths) const;

  const PieceBlocks& blocks_;
  bool anyMissing_;
  RunningSums volumes_;
};

}  // namespace isolux::volume
