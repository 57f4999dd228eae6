// Which blocks an isovalue makes active, kept up to date in time proportional to what a new isovalue changes.
//
// A block enters or leaves the active set only when the isovalue passes its minimum or its maximum. Blocks
// are sorted by both once; a new isovalue touches the two ranges of blocks whose minimum or maximum lies
// between the old and the new one, found by binary search (Hadwiger et al. 2005 sec. 3.1; Cignoni, Scopigno &
// Tarini 1998). A block is active when it is for any of several isovalues. Isovalues are stored units.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "volume/skip/min_max_blocks.h"

namespace isolux::volume {

class ActiveBlocks {
 public:
  static constexpr std::size_t kMaximumIsovalues = 255;

  // No isovalue: nothing is active. Sorts the blocks, multithreaded; 16 bytes per block that is not constant.
  // More blocks than mostSorted (1290 voxels per axis) are not sorted: each update looks at all.
  explicit ActiveBlocks(std::shared_ptr<const MinMaxBlocks> blocks,
                        std::size_t mostSorted = std::size_t{1} << 22);

  // Makes active what MinMaxBlocks::active() says for any of the isovalues (at most kMaximumIsovalues, in any
  // order; NaN is active nowhere). Returns the blocks whose flag changed, each once, in no particular order;
  // the list is valid until the next call. A step past many blocks costs no more than a scan of all.
  std::span<const std::uint32_t> update(std::span<const float> storedIsovalues);

  const MinMaxBlocks& blocks() const { return *blocks_; }
  // One byte per block, 1 where active; x fastest.
  const std::vector<std::uint8_t>& flags() const { return flags_; }
  std::size_t activeCount() const { return activeCount_; }

 private:
  struct Bound {
    float value;
    std::uint32_t block;
  };
  // No isovalue: below every block.
  static constexpr float kNone = -std::numeric_limits<float>::infinity();

  void look();  // at all blocks
  void move(float from, float to);
  void touch(std::uint32_t block, int change);

  std::shared_ptr<const MinMaxBlocks> blocks_;
  bool isSorted_;
  std::vector<Bound> byMinimum_, byMaximum_;  // ascending; without blocks that are constant or missing
  std::vector<float> isovalues_;              // ascending
  std::vector<std::uint8_t> isovaluesIn_;     // of each block
  std::vector<std::uint8_t> flags_;
  std::size_t activeCount_ = 0;
  std::vector<std::uint32_t> touched_, changed_;
};

}  // namespace isolux::volume
