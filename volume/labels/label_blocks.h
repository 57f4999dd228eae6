// Lists the labels of a volume, how many voxels each has, and the labels of every block of 8 x 8 x 8 voxels.
//
// A label is the value of a voxel (data units), a whole number within int; missing voxels have none. Blocks
// count from voxel (0, 0, 0), x fastest; the last ones of an axis may be smaller. Immutable; any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "base/memory_budget.h"
#include "base/progress.h"
#include "volume/grid.h"

namespace isolux::volume {

struct LabelExtent {
  int label = 0;
  float stored = 0.0f;  // stored value of its voxels
  std::size_t voxels = 0;
  glm::ivec3 low{0}, high{0};  // first and last voxel of the blocks that hold it
};

class LabelBlocks {
 public:
  static constexpr int kSize = 8;
  static constexpr std::size_t kMostLabels = 65535;
  static constexpr std::uint16_t kMissing = 65535;  // in of(): the block has voxels without a label

  // One pass over the voxels, on all cores. Throws Error{input} with `file` if a value is not a whole number,
  // is outside of int, or if there are more than kMostLabels; Error: interrupted, memory.
  LabelBlocks(std::shared_ptr<const Grid> grid, const std::string& file, base::Progress& progress);

  const Grid& grid() const { return *grid_; }
  // In ascending order of label.
  const std::vector<LabelExtent>& list() const { return list_; }
  Extent3 blocks() const { return blocks_; }
  // Returns the indices in list() of the labels of a block, each once, in no order.
  std::span<const std::uint16_t> of(std::size_t block) const {
    return std::span(indices_).subspan(begins_[block], begins_[block + 1] - begins_[block]);
  }

 private:
  std::shared_ptr<const Grid> grid_;
  Extent3 blocks_;
  std::vector<LabelExtent> list_;
  std::vector<std::uint32_t> begins_;  // in indices_, of each block, and their end
  std::vector<std::uint16_t> indices_;
  base::MemoryBudget::Held held_;
};

}  // namespace isolux::volume
