#include "volume/statistics/label_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <vector>

namespace isolux::volume {

namespace {

constexpr std::size_t kMostValues = 2048;  // atlases have some hundreds
constexpr double kMostUnequal = 0.4;       // of neighbours within objects; thin vessels come near it
constexpr double kLeastJumps = 0.2;        // of unequal neighbours
constexpr std::size_t kFrequent = 200;     // voxels: a label of so many fills more than its border
constexpr double kLeastBodies = 0.5;       // of frequent values
constexpr std::size_t kEnough = 1 << 20;   // voxels that neighbours are compared of

using ValueCounts = std::map<double, std::size_t>;  // of values

// Adds a row; false: a value is no whole number, or there are too many.
bool addRow(const Grid& grid, int y, int z, ValueCounts& counts) {
  double last = std::numeric_limits<double>::quiet_NaN();
  std::size_t* count = nullptr;  // of it: runs are long
  for (int x = 0; x < grid.dims().x; ++x) {
    const double value = grid.value(x, y, z);
    if (std::isnan(value)) continue;
    if (value != last) {
      if (value != std::floor(value)) return false;
      count = &counts[value];
      last = value;
    }
    ++*count;
  }
  return counts.size() <= kMostValues;
}

struct Neighbours {
  std::size_t pairs = 0, unequal = 0, jumps = 0;  // pairs that are not both background
};

void compare(double a, double b, double background, const std::vector<double>& values, Neighbours& result) {
  if (std::isnan(a) || std::isnan(b) || (a == background && b == background)) return;
  ++result.pairs;
  if (a == b) return;
  ++result.unequal;
  const auto rank = [&](double value) { return std::lower_bound(values.begin(), values.end(), value); };
  if (std::abs(rank(a) - rank(b)) > 1) ++result.jumps;
}

bool insideItsRegion(const Grid& grid, glm::ivec3 at) {
  const double value = grid.value(at);
  for (int axis = 0; axis < 3; ++axis)
    for (const int step : {-1, 1}) {
      glm::ivec3 beside = at;
      beside[axis] += step;
      const bool exists = beside[axis] >= 0 && beside[axis] < grid.dims()[axis];
      if (exists && grid.value(beside) != value) return false;
    }
  return true;
}

}  // namespace

std::optional<LabelMap> labelMapOf(const Grid& grid, bool asked, const base::Progress& progress) {
  const glm::ivec3 dims = grid.dims();
  const Extent3 extent{dims};
  const std::size_t stride = std::max<std::size_t>(1, extent.count() / kEnough);
  const auto eachRow = [&](std::size_t step, const auto& body) {
    for (std::size_t row = 0; row < extent.rows(); row += step) {
      progress.throwIfStopped();
      const glm::ivec3 first = extent.firstOfRow(row);
      if (!body(first.y, first.z)) return false;
    }
    return true;
  };
  ValueCounts counts;
  if (!eachRow(stride, [&](int y, int z) { return addRow(grid, y, z, counts); })) return std::nullopt;
  if (counts.size() < (asked ? 2 : 3)) return std::nullopt;
  const double background = std::ranges::max_element(counts, {}, &ValueCounts::value_type::second)->first;
  std::vector<double> values;
  for (const auto& [value, count] : counts) values.push_back(value);

  Neighbours found;
  std::set<double> bodies;  // values of voxels whose neighbours all have the same one
  eachRow(stride, [&](int y, int z) {
    for (int x = 0; x < dims.x; ++x) {
      const double here = grid.value(x, y, z);
      if (here != background && insideItsRegion(grid, {x, y, z})) bodies.insert(here);
      if (x + 1 < dims.x) compare(here, grid.value(x + 1, y, z), background, values, found);
      if (y + 1 < dims.y) compare(here, grid.value(x, y + 1, z), background, values, found);
      if (z + 1 < dims.z) compare(here, grid.value(x, y, z + 1), background, values, found);
    }
    return true;
  });
  const auto part = [](std::size_t of, std::size_t all) {
    return all == 0 ? 0.0 : static_cast<double>(of) / static_cast<double>(all);
  };
  std::size_t frequent = 0,
              filled = 0;  // of a scan's values few fill anything: air, a table, what is clipped
  for (const auto& [value, count] : counts)
    if (value != background && count >= kFrequent) {
      ++frequent;
      filled += bodies.contains(value) ? 1 : 0;
    }
  const bool measures = bodies.size() < 2 || part(found.unequal, found.pairs) > kMostUnequal ||
                        part(found.jumps, found.unequal) < kLeastJumps ||
                        (frequent > 0 && part(filled, frequent) < kLeastBodies);
  if (measures && !asked) return std::nullopt;
  if (stride > 1) {  // rare labels lie between the rows
    counts.clear();
    if (!eachRow(1, [&](int y, int z) { return addRow(grid, y, z, counts); })) return std::nullopt;
  }
  return LabelMap{background, static_cast<int>(counts.size()) - 1};
}

}  // namespace isolux::volume
