#include "volume/visible/voxel_mask.h"

#include <algorithm>

#include "base/hash.h"

namespace isolux::volume {

VoxelMask::VoxelMask(glm::ivec3 dims, bool hidesStrays)
    : dims_(dims),
      hidesStrays_(hidesStrays),
      wordsPerRow_((dims.x + kVoxelsPerWord - 1) / kVoxelsPerWord),
      words_(static_cast<std::size_t>(wordsPerRow_) * Extent3{dims}.rows()) {}

void VoxelMask::hide(int begin, int end, int y, int z) {
  any_ = any_ || begin < end;
  for (int x = begin; x < end;) {
    const int bit = x % kVoxelsPerWord;
    const int count = std::min(end - x, kVoxelsPerWord - bit);
    const std::uint64_t ones = count == kVoxelsPerWord ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
    words_[word({x, y, z})] |= ones << bit;
    x += count;
  }
}

std::uint64_t VoxelMask::key() const {
  if (!any()) return 0;
  base::Hasher hash;
  hash.addWords(words_.data(), words_.size() * sizeof(std::uint64_t));
  return hash;
}

}  // namespace isolux::volume
