// Filters the lines of samples along an axis of a volume in place, many side by side, on all cores.
#pragma once

#include <algorithm>
#include <vector>

#include <tbb/enumerable_thread_specific.h>
#include <glm/vec3.hpp>

#include "volume/parallel/parallel_steps.h"

namespace isolux::volume {

inline constexpr std::size_t kLines = 16;  // filtered side by side: one SIMD lane each

// Neighbouring lines of samples along one axis: line r has sample k at first[k * stride + r * lineStride].
struct FilterLines {
  float* first;
  std::size_t count, length, stride, lineStride;
};

// Calls a copy of `filter`, one for each thread, for up to kLines lines at a time.
template <class Filter>
void filterLines(int axis, std::vector<float>& values, const glm::ivec3& size, base::Progress& progress,
                 base::ProgressRange share, const Filter& filter) {
  const std::size_t dims[3] = {static_cast<std::size_t>(size.x), static_cast<std::size_t>(size.y),
                               static_cast<std::size_t>(size.z)};
  const std::size_t strides[3] = {1, dims[0], dims[0] * dims[1]};
  const int along = axis == 0 ? 1 : 0, across = axis == 2 ? 1 : 2;  // lines beside one another; and the rest
  const std::size_t bundles = (dims[along] + kLines - 1) / kLines;
  tbb::enumerable_thread_specific<Filter> filters(filter);
  parallelSteps(bundles * dims[across], progress, share, [&](std::size_t step) {
    const std::size_t line = step % bundles * kLines;
    filters.local()({values.data() + line * strides[along] + step / bundles * strides[across],
                     std::min(kLines, dims[along] - line), dims[axis], strides[axis], strides[along]});
  });
}

}  // namespace isolux::volume
