// Which of many intervals side by side holds a number, in constant time on average.
//
// [0, 2^31) is cut into 2^bits cells of equal width, and the table names the interval that each begins in
// (Chen & Asau 1974; Devroye 1986, sec. III.2.4); a binary search in what the cell meets finds the rest. It
// finds what a search in all of them finds, so the map from numbers to intervals is monotone and keeps the
// stratification of a sequence. A cell meets some eight intervals on average: fewer would cost more memory
// than the search takes steps, and it is memory that is waited for.
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

// Of a table: one place a cell and one behind them for the last interval.
inline std::size_t guideSize(std::size_t intervals) {
  return (std::size_t{1} << guideBits(intervals)) + 1;
}

// starts: ascending, the first 0, all at most 2^31; interval i is [starts[i], starts[i + 1]).
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

// The last interval that begins at or before `value`, which is below 2^31.
inline std::size_t intervalOf(std::span<const std::uint32_t> starts, std::span<const std::uint32_t> guide,
                              std::uint32_t value) {
  const std::uint32_t* const cell = guide.data() + (value >> (31 - guideBits(starts.size())));
  const auto after = std::upper_bound(starts.begin() + cell[0] + 1, starts.begin() + cell[1] + 1, value);
  return static_cast<std::size_t>(after - starts.begin()) - 1;
}

}  // namespace isolux::gi
