// What neighbouring voxels of a volume differ by, of which only some rows are looked at.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "volume/voxels/extent.h"

namespace isolux::volume {

// What neighbours differ by where they differ, along any axis: the 90 % quantile over an even subsample of
// the rows. rowOf(y, z): the values of a row, NaN where missing, until it is called again. 0 where nothing
// differs. Throws Error{interrupted}, and what rowOf throws.
template <class RowOf>
double typicalStep(glm::ivec3 dims, const RowOf& rowOf, const base::Progress& progress) {
  constexpr std::size_t enough = 1 << 16;
  const Extent3 extent{dims};
  const std::size_t stride = std::max<std::size_t>(1, extent.count() / enough);
  std::vector<double> steps;
  const auto add = [&](double here, double there) {
    const double step = std::abs(there - here);
    if (step > 0.0) steps.push_back(step);  // false for missing voxels
  };
  for (std::size_t row = 0; row < extent.rows(); row += stride) {
    progress.throwIfStopped();
    const int y = extent.firstOfRow(row).y, z = extent.firstOfRow(row).z;
    const auto here = rowOf(y, z);
    const std::vector<double> values(here.begin(), here.end());
    for (std::size_t x = 1; x < values.size(); ++x) add(values[x - 1], values[x]);
    for (const bool up : {false, true}) {
      if (up ? z + 1 == dims.z : y + 1 == dims.y) continue;
      const auto next = up ? rowOf(y, z + 1) : rowOf(y + 1, z);
      for (std::size_t x = 0; x < values.size(); ++x) add(values[x], next[x]);
    }
  }
  if (steps.empty()) return 0.0;
  const auto at = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() * 9 / 10);
  std::nth_element(steps.begin(), at, steps.end());
  return *at;
}

}  // namespace isolux::volume
