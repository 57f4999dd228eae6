#include "tests/support/first_entry.h"

#include <array>
#include <cmath>

#include "volume/hit/bernstein_cubic.h"

namespace isolux::volume {

namespace {

// Goes through the pieces of one cell's segment; s of the first entry. `outside` is the side before and then
// behind; false: inside or unknown.
std::optional<double> entryOf(const BernsteinCubic& cubic, bool& outside) {
  std::array<double, 2> extrema{};
  const int count = cubic.extrema(extrema);
  double low = 0.0, atLow = cubic.b[0];
  for (int i = 0; i <= count; ++i) {
    const double high = i < count ? extrema[static_cast<std::size_t>(i)] : 1.0;
    const double atHigh = i < count ? cubic(high) : cubic.b[3];
    const bool beginsOutside = atLow < 0.0 || (atLow == 0.0 && atHigh < 0.0);
    if (outside && !beginsOutside) return low;
    if (atLow < 0.0 && atHigh > 0.0) return bracketedRoot(cubic, low, high, atLow, atHigh, true);
    outside = beginsOutside || atHigh < 0.0;
    low = high;
    atLow = atHigh;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> firstEntry(const Grid& grid, scene::Inside inside, double storedIsovalue,
                                 const Ray& ray) {
  const glm::ivec3 dims = grid.dims();
  if (dims.x < 2 || dims.y < 2 || dims.z < 2 || std::isnan(storedIsovalue) || !ray.valid())
    return std::nullopt;
  const double sign = (inside == scene::Inside::above) == (grid.slope() > 0.0) ? 1.0 : -1.0;
  CellWalk walk(dims, ray);
  bool outside = false;
  for (bool more = walk.inside(); more; more = walk.next()) {
    const auto segment = walk.segment();
    if (!segment) continue;
    const glm::ivec3 cell = walk.cell();
    CellCorners corner;
    int below = 0;
    bool missing = false;
    for (std::size_t i = 0; i < 8; ++i) {
      const int x = cell.x + static_cast<int>(i & 1), y = cell.y + static_cast<int>(i >> 1 & 1),
                z = cell.z + static_cast<int>(i >> 2);
      corner[i] = sign * (grid.stored(x, y, z) - storedIsovalue);
      missing = missing || std::isnan(corner[i]);
      below += corner[i] < 0.0 ? 1 : 0;
    }
    if (missing) {
      outside = false;
      continue;
    }
    if (below == 8) {
      outside = true;
      continue;
    }
    if (below == 0) {
      if (outside) return segment->t(0.0);
      continue;
    }
    const BernsteinCubic cubic = BernsteinCubic::along(corner, segment->from, segment->to);
    if (const auto s = entryOf(cubic, outside)) return segment->t(*s);
  }
  return std::nullopt;
}

}  // namespace isolux::volume
