// Loops over voxels on all cores that tell how far they are and end soon after a stop.
//
// A step should take a few milliseconds at most: that, and what the system gives to other programs, is how
// long a stop can take. Not for GL or UI threads where the loop as a whole is long.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <vector>

#include "base/progress.h"
#include "volume/parallel_loops.h"

namespace isolux::volume {

// Calls step(i) for each i in [0, count), in any order, on all cores. Throws Error{interrupted} once a stop
// was requested; some steps have not run then.
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

// The same for ranges [begin, end) of `count` elements, `length` of them at a time.
template <class Step>
void parallelPieces(std::size_t count, std::size_t length, base::Progress& progress,
                    base::ProgressRange share, const Step& step) {
  parallelSteps((count + length - 1) / length, progress, share,
                [&](std::size_t piece) { step(piece * length, std::min(count, (piece + 1) * length)); });
}

// Makes `values` `count` elements long. The system hands out and clears memory as it is first written, which
// takes long for gigabytes, so a stop is looked for on the way. Throws Error{interrupted}.
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
