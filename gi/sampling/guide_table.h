// Finds which of many adjacent intervals contains a number, in constant time on average.
//
// Divides [0, 2^31) into 2^bits cells of equal width. The table stores the interval in which each cell begins
// (Chen & Asau 1974; Devroye 1986, sec. III.2.4). A binary search among the cell's intervals finds the
// result. The result equals that of a search among all intervals. The map from numbers to intervals is
// therefore monotone and preserves the stratification of a sequence. A cell overlaps about eight intervals on
// average: fewer would cost more memory accesses than the search steps they save.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace isolux::gi {

inline int guideBits(std::size_t intervals) {
  return std::max(0, static_cast<int>(std::bit_width(intervals)) - 3);
}

// Returns the size of a table: one entry per cell and one more for the last interval.
inline std::size_t guideSize(std::size_t intervals) {
  return (std::size_t{1} << guideBits(intervals)) + 1;
}

// Fills the table. `starts`: ascending, the first 0, all at most 2^31; interval i is [starts[i], starts[i +
// 1]).
inline void fillGuide(std::span<const std::uint32_t> starts, std::span<std::uint32_t> guide) {
  const int shift = 31 - guideBits(starts.size());
  std::uint32_t interval = 0;
  for (std::size_t cell = 0; cell + 1 < guide.size(); ++cell) {
    const auto begin = static_cast<std::uint32_t>(cell << shift);
    while (interval + 1 < starts.size() && starts[interval + 1] <= begin) ++interval;
    guide[cell] = interval;
  }
  guide[guide.size() - 1] = static_cast<std::uint32_t>(starts.size()) - 1;
}

// Returns the last interval that begins at or before `value`. Requires `value` < 2^31.
inline std::size_t intervalOf(std::span<const std::uint32_t> starts, std::span<const std::uint32_t> guide,
                              std::uint32_t value) {
  const std::uint32_t* const cell = guide.data() + (value >> (31 - guideBits(starts.size())));
  const auto after = std::upper_bound(starts.begin() + cell[0] + 1, starts.begin() + cell[1] + 1, value);
  return static_cast<std::size_t>(after - starts.begin()) - 1;
}

}  // namespace isolux::gi
