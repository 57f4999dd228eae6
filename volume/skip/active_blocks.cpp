#include "volume/skip/active_blocks.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <tbb/parallel_sort.h>

namespace isolux::volume {

ActiveBlocks::ActiveBlocks(std::shared_ptr<const MinMaxBlocks> blocks, std::size_t mostSorted)
    : blocks_(std::move(blocks)), isSorted_(blocks_->count() <= mostSorted), flags_(blocks_->count()) {
  if (!isSorted_) return;
  isovaluesIn_.resize(blocks_->count());
  for (std::size_t i = 0; i < blocks_->count(); ++i) {
    if (!(blocks_->minimum(i) < blocks_->maximum(i))) continue;
    const auto block = static_cast<std::uint32_t>(i);
    byMinimum_.push_back({blocks_->minimum(i), block});
    byMaximum_.push_back({blocks_->maximum(i), block});
  }
  const auto ascending = [](const Bound& a, const Bound& b) {
    return a.value != b.value ? a.value < b.value : a.block < b.block;
  };
  tbb::parallel_sort(byMinimum_.begin(), byMinimum_.end(), ascending);
  tbb::parallel_sort(byMaximum_.begin(), byMaximum_.end(), ascending);
}

std::span<const std::uint32_t> ActiveBlocks::update(std::span<const float> storedIsovalues) {
  assert(storedIsovalues.size() <= kMaximumIsovalues);
  isovalues_.resize(std::max(storedIsovalues.size(), isovalues_.size()), kNone);
  std::vector<float> wanted(isovalues_.size(), kNone);
  for (std::size_t i = 0; i < storedIsovalues.size(); ++i)
    if (!std::isnan(storedIsovalues[i])) wanted[i] = storedIsovalues[i];
  // The same isovalues in another order are no change.
  std::sort(isovalues_.begin(), isovalues_.end());
  std::sort(wanted.begin(), wanted.end());

  touched_.clear();
  changed_.clear();
  if (!isSorted_) {
    if (wanted == isovalues_) return changed_;
    isovalues_ = wanted;
    look();
    return changed_;
  }
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (wanted[i] != isovalues_[i]) move(isovalues_[i], wanted[i]);
  isovalues_ = wanted;
  // A block may be touched more than once, and end as it was.
  for (const std::uint32_t block : touched_) {
    const std::uint8_t flag = isovaluesIn_[block] > 0 ? 1 : 0;
    if (flag == flags_[block]) continue;
    flags_[block] = flag;
    flag ? ++activeCount_ : --activeCount_;
    changed_.push_back(block);
  }
  return changed_;
}

void ActiveBlocks::look() {
  for (std::uint32_t block = 0; block < blocks_->count(); ++block) {
    const std::uint8_t flag = std::any_of(isovalues_.begin(), isovalues_.end(),
                                          [&](float isovalue) { return blocks_->active(block, isovalue); });
    if (flag == flags_[block]) continue;
    flags_[block] = flag;
    flag ? ++activeCount_ : --activeCount_;
    changed_.push_back(block);
  }
  changed_.shrink_to_fit();
}

void ActiveBlocks::touch(std::uint32_t block, int change) {
  isovaluesIn_[block] = static_cast<std::uint8_t>(isovaluesIn_[block] + change);
  touched_.push_back(block);
}

// One isovalue moves. Upward from a to b: blocks with a < minimum <= b <= maximum come, those with minimum <=
// a <= maximum < b go. Downward is the same with the roles of coming and going exchanged.
void ActiveBlocks::move(float from, float to) {
  const float low = std::min(from, to), high = std::max(from, to);
  const int change = from < to ? 1 : -1;
  const auto below = [](const Bound& bound, float value) { return bound.value < value; };
  const auto above = [](float value, const Bound& bound) { return value < bound.value; };
  const auto minimaBegin = std::upper_bound(byMinimum_.begin(), byMinimum_.end(), low, above);
  const auto minimaEnd = std::upper_bound(minimaBegin, byMinimum_.end(), high, above);
  const auto maximaBegin = std::lower_bound(byMaximum_.begin(), byMaximum_.end(), low, below);
  const auto maximaEnd = std::lower_bound(maximaBegin, byMaximum_.end(), high, below);

  // The sorted ranges lead to blocks all over memory: past this many, reading all in order is faster.
  const auto steps = static_cast<std::size_t>((minimaEnd - minimaBegin) + (maximaEnd - maximaBegin));
  if (steps > blocks_->count() / 4) {
    for (std::uint32_t block = 0; block < blocks_->count(); ++block) {
      const bool atHigh = blocks_->active(block, high);
      if (atHigh != blocks_->active(block, low)) touch(block, atHigh ? change : -change);
    }
    return;
  }
  for (auto bound = minimaBegin; bound != minimaEnd; ++bound)
    if (blocks_->maximum(bound->block) >= high) touch(bound->block, change);
  for (auto bound = maximaBegin; bound != maximaEnd; ++bound)
    if (blocks_->minimum(bound->block) <= low) touch(bound->block, -change);
}

}  // namespace isolux::volume
