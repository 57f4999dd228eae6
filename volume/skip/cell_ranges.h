// Which isovalues every cell and every block of 4^3 and 16^3 cells can hold, as ranges of value bins: what a
// ray skips by.
//
// Values are sorted into 255 bins by a monotone map; bin(a) < bin(b) means a < b, so that comparing bins
// never skips a surface, whatever the rounding of the map. Half of the bins follow the distribution of the
// voxels, half the range. Isovalues are stored units.
//
// The table begins with one word of four bytes per block of 4^3 cells, x fastest: smallest and largest bin of
// the block, then of the 16^3 block around it. Behind cellBytes() follow, block after block, two bytes per
// cell (smallest, largest bin), x fastest within the block. A range that holds a missing voxel is [0, 255];
// cells beyond the last one hold [255, 0] and are in no other range.
//
// Where pieces are hidden, for one isovalue: their voxels count as far outside.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "volume/grid.h"
#include "volume/visible/voxel_mask.h"

namespace isolux::volume {

// The monotone map from stored values to bins 0 .. 254.
class ValueBins {
 public:
  explicit ValueBins(const Grid& grid);

  std::uint8_t operator()(float stored) const {
    const double at = (static_cast<double>(stored) - low_) * scale_;
    return table_[static_cast<std::size_t>(at > 0.0 ? (at < last_ ? at : last_) : 0.0)];
  }

 private:
  static constexpr double last_ = 4095.0;
  double low_ = 0.0, scale_ = 0.0;
  std::vector<std::uint8_t> table_;
};

class CellRanges {
 public:
  // Multithreaded. Throws Error{interrupted}. Grids without cells have an empty table. hidden: null where all
  // is shown; insideHigh: of its pieces, stored values from the isovalue up.
  CellRanges(const Grid& grid, base::Progress& progress, const VoxelMask* hidden = nullptr,
             bool insideHigh = true);

  static std::size_t bytesOf(glm::ivec3 dims);  // of the table for so many voxels

  const ValueBins& bins() const { return bins_; }
  glm::ivec3 blockDims() const { return blockDims_; }          // blocks of 4^3 cells
  std::size_t cellBytes() const { return cellBytes_; }         // where the cells begin in the table
  const std::uint8_t* table() const { return table_.data(); }  // four bytes may be read at every cell
  std::size_t bytes() const { return table_.size(); }

 private:
  ValueBins bins_;
  glm::ivec3 blockDims_{0};
  std::size_t cellBytes_ = 0;
  std::vector<std::uint8_t> table_;
};

}  // namespace isolux::volume
