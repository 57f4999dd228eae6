// Which of many intervals side by side holds a number, in constant time on average.
//
// [0, 2^31) is cut into 2^bits cells of equal width, and the table names the interval that each begins in
// (Chen & Asau 1974; Devroye 1986, sec. III.2.4): the search goes on from there. It finds what a binary
// search finds, so the map from numbers to intervals is monotone and keeps the stratification of a sequence.
// The mean number of further steps, over all numbers, is the number of intervals over that of cells.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace isolux::gi {

// The largest power of two that does not exceed the number of intervals.
inline int guideBits(std::size_t intervals) {
  return static_cast<int>(std::bit_width(intervals)) - 1;
}

// starts: ascending, the first 0, all at most 2^31; interval i is [starts[i], starts[i + 1]). guide: 2^bits.
inline void fillGuide(std::span<const std::uint32_t> starts, std::span<std::uint32_t> guide) {
  const int shift = 31 - guideBits(guide.size());
  std::uint32_t interval = 0;
  for (std::size_t cell = 0; cell < guide.size(); ++cell) {
    const auto begin = static_cast<std::uint32_t>(cell << shift);
    while (interval + 1 < starts.size() && starts[interval + 1] <= begin) ++interval;
    guide[cell] = interval;
  }
}

// The last interval that begins at or before `value`, which is below 2^31.
inline std::size_t intervalOf(std::span<const std::uint32_t> starts, std::span<const std::uint32_t> guide,
                              std::uint32_t value) {
  std::size_t interval = guide[value >> (31 - guideBits(guide.size()))];
  while (interval + 1 < starts.size() && starts[interval + 1] <= value) ++interval;
  return interval;
}

}  // namespace isolux::gi
