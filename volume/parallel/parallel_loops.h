// Runs loops on all threads that the program may use (oneTBB's, compiled once: its templates cost each use
// 0.2 s of compile time).
#pragma once

#include <cstddef>

namespace isolux::volume {

// The indices in [first, last).
template <class Index>
struct Indices {
  Index first, last;
  Index begin() const { return first; }
  Index end() const { return last; }
  std::size_t size() const { return static_cast<std::size_t>(last - first); }
};

// As parallelRanges(), with a type-erased function: body(work, first, last).
using RangeBody = void (*)(const void* work, std::size_t first, std::size_t last);
void runRanges(std::size_t count, std::size_t grain, const void* work, RangeBody body);

// Calls work(Indices) for ranges that make up [0, count), in any order; does nothing unless count is
// positive. A range is divided only while it has more than `grain` indices (at least 1). Rethrows an
// exception of a call; other calls may then be skipped.
template <class Index, class Work>
void parallelRanges(Index count, std::size_t grain, const Work& work) {
  if (count <= 0) return;
  runRanges(static_cast<std::size_t>(count), grain, &work,
            [](const void* called, std::size_t first, std::size_t last) {
              (*static_cast<const Work*>(called))(
                  Indices<Index>{static_cast<Index>(first), static_cast<Index>(last)});
            });
}

// Calls work(i) for each i in [0, count) in the same way.
template <class Index, class Work>
void parallelEach(Index count, const Work& work) {
  parallelRanges(count, 1, [&](const Indices<Index>& range) {
    for (Index i = range.first; i != range.last; ++i) work(i);
  });
}

}  // namespace isolux::volume
