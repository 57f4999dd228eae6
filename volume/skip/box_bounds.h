// Which 2x2x2-cell boxes of a block an isosurface can cross: a second, finer level below MinMaxBlocks, for
// blocks of 8.
//
// A box holds 2x2x2 cells and so 3x3x3 voxels (with the apron of a cubic field: 5x5x5). Its bounds are kept
// in 16 bits, rounded outward, so an answer may be "can" where it cannot, never the other way. A box with a
// missing voxel can always. Values are stored units.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "volume/field/coefficients.h"
#include "volume/grid.h"
#include "volume/skip/min_max_blocks.h"

namespace isolux::volume {

class BoxBounds {
 public:
  static constexpr int kBlockCells = 8, kBoxCells = 2, kBoxesPerBlock = 64;

  // Of the trilinear field. `blocks`: those of the grid, of kBlockCells cells. Multithreaded; 256 bytes for
  // each block, but constant ones; throws Error: memory, before these are made; interrupted.
  BoxBounds(const Grid& grid, const MinMaxBlocks& blocks, base::Progress& progress);
  // The same where those of a grid are known that differs at most in the blocks whose byte is not 0.
  BoxBounds(const BoxBounds& before, const Grid& grid, const MinMaxBlocks& blocks,
            std::span<const std::uint8_t> changed, base::Progress& progress);
  // Of the cubic B-spline with these coefficients (without their offset), or, where they are null, of that
  // whose coefficients are the samples.
  static BoxBounds ofCubic(const Grid& grid, const Coefficients* coefficients, base::Progress& progress);

  // Of the trilinear field of a part of a volume: `dims` voxels, x fastest. Bounds are those of the same
  // voxels in the BoxBounds of `whole`, whose voxels need not be in memory.
  static BoxBounds ofPart(const VoxelArray& voxels, glm::ivec3 dims, const Grid& whole,
                          base::Progress& progress);

  glm::ivec3 blockDims() const { return dims_; }
  // Of each block a mask: bit x + 4 y + 16 z is set where that box can hold a crossing of one of the
  // isovalues; 0 for blocks whose flag is 0, and constant ones. `flags`: one byte per block, x fastest.
  // Multithreaded.
  void masks(std::span<const float> storedIsovalues, const std::vector<std::uint8_t>& flags,
             std::vector<std::uint64_t>& result) const;
  std::size_t bytes() const {
    return bounds_.size() * sizeof(Bounds) + places_.size() * sizeof(std::uint32_t);
  }

 private:
  struct Bounds {  // of a block's boxes; low > high where there is no box
    std::uint16_t low[kBoxesPerBlock], high[kBoxesPerBlock];
  };
  explicit BoxBounds(glm::ivec3 voxels);
  template <class T>
  void fill(const std::vector<T>& voxels, const volume::Bounds<float>& range, glm::ivec3 voxelDims, int apron,
            base::Progress& progress, const MinMaxBlocks* known = nullptr, const BoxBounds* before = nullptr,
            std::span<const std::uint8_t> changed = {});

  // Gives each block its place in bounds_, and makes room; those that `known` calls constant have none.
  void place(const MinMaxBlocks* known, const base::Progress& progress);

  static constexpr std::uint32_t kNoPlace = UINT32_MAX;
  glm::ivec3 dims_;
  double origin_ = 0.0, scale_ = 1.0;  // quantised = (stored - origin) * scale
  std::vector<std::uint32_t> places_;  // of each block in bounds_
  std::vector<Bounds> bounds_;
  base::MemoryBudget::Held held_;
};

}  // namespace isolux::volume
