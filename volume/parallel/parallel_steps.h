// Runs loops over voxels on all cores that report progress and end soon after a stop request.
//
// A step should take a few milliseconds at most: the time to stop is that of a step, plus what the system
// gives to other programs. Not for GL or UI threads if the whole loop is long.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <vector>

#include "base/progress.h"
#include "volume/parallel/parallel_loops.h"

namespace isolux::volume {

// Calls step(i) for each i in [0, count), in any order, on all cores. Throws Error{interrupted} after a stop
// request; some steps have then not run.
template <class Step>
void parallelSteps(std::size_t count, base::Progress& progress, base::ProgressRange share, const Step& step) {
  std::atomic<std::size_t> done{0};
  parallelRanges(count, 1, [&](const Indices<std::size_t>& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      if (progress.stopRequested()) return;
      step(i);
      const std::size_t ended = done.fetch_add(1, std::memory_order_relaxed) + 1;
      if (share.stage)
        progress.report(
            share.from + (share.to - share.from) * static_cast<double>(ended) / static_cast<double>(count),
            share.stage);
    }
  });
  progress.throwIfStopped();
}

// As above for ranges [begin, end) of `count` elements, `length` of them at a time.
template <class Step>
void parallelPieces(std::size_t count, std::size_t length, base::Progress& progress,
                    base::ProgressRange share, const Step& step) {
  parallelSteps((count + length - 1) / length, progress, share,
                [&](std::size_t piece) { step(piece * length, std::min(count, (piece + 1) * length)); });
}

// Resizes `values` to `count` elements. The system allocates and clears memory at the first write, which
// takes long for gigabytes, so stop requests are polled in between. Throws Error{interrupted}.
template <class T>
void resizeStoppably(std::vector<T>& values, std::size_t count, const base::Progress& progress) {
  constexpr std::size_t bytes = std::size_t{4} << 20;
  values.reserve(count);
  while (values.size() < count) {
    progress.throwIfStopped();
    values.resize(std::min(count, values.size() + bytes / sizeof(T)));
  }
}

}  // namespace isolux::volume
