#include "volume/parallel/parallel_loops.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace isolux::volume {

void runRanges(std::size_t count, std::size_t grain, const void* work, RangeBody body) {
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count, grain),
      [&](const tbb::blocked_range<std::size_t>& range) { body(work, range.begin(), range.end()); });
}

}  // namespace isolux::volume
