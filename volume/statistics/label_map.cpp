#include "volume/statistics/label_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <type_traits>
#include <vector>

#include <tbb/combinable.h>

#include "volume/parallel/parallel_steps.h"

namespace isolux::volume {

namespace {

constexpr double kMostUnequal = 0.4;      // of neighbours within objects; thin vessels come near it
constexpr double kLeastJumps = 0.2;       // of unequal neighbours
constexpr std::size_t kFrequent = 200;    // voxels: a label of so many fills more than its border
constexpr double kLeastBodies = 0.5;      // of frequent values
constexpr std::size_t kEnough = 1 << 20;  // voxels that neighbours are compared of

// Adds the voxels from `begin` to `end`, of whole numbers that are stored as integers of at most 16 bits.
template <class T>
void addStored(const std::vector<T>& voxels, std::size_t begin, std::size_t end,
               std::vector<std::size_t>& counts) {
  for (std::size_t i = begin; i < end; ++i)
    ++counts[static_cast<std::size_t>(static_cast<int>(voxels[i]) - std::numeric_limits<T>::min())];
}

// Of a type of which few values exist: all of them are counted, in any order.
template <class T>
ValueCounts countsOfStored(const Grid& grid, const std::vector<T>& voxels, base::Progress& progress) {
  constexpr std::size_t values = std::size_t{1} << (8 * sizeof(T));
  tbb::combinable<std::vector<std::size_t>> partial([] { return std::vector<std::size_t>(values); });
  parallelPieces(voxels.size(), std::size_t{1} << 20, progress, {},
                 [&](std::size_t begin, std::size_t end) { addStored(voxels, begin, end, partial.local()); });
  std::vector<std::size_t> sum(values);
  partial.combine_each([&](const std::vector<std::size_t>& counts) {
    for (std::size_t i = 0; i < values; ++i) sum[i] += counts[i];
  });
  ValueCounts counts;
  for (std::size_t i = 0; i < values; ++i)
    if (sum[i] > 0)
      counts[grid.valueOfStored(static_cast<double>(i) + std::numeric_limits<T>::min())] += sum[i];
  return counts;
}

// Adds a row; false: a value is no whole number, or there are too many.
bool addRow(const Grid& grid, int y, int z, std::size_t most, ValueCounts& counts) {
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
  return counts.size() <= most;
}

// Of each `stride`th row.
std::optional<ValueCounts> countsOfRows(const Grid& grid, std::size_t stride, std::size_t most,
                                        const base::Progress& progress) {
  const Extent3 extent{grid.dims()};
  ValueCounts counts;
  for (std::size_t row = 0; row < extent.rows(); row += stride) {
    progress.throwIfStopped();
    const glm::ivec3 first = extent.firstOfRow(row);
    if (!addRow(grid, first.y, first.z, most, counts)) return std::nullopt;
  }
  return counts;
}

// Integers are counted whole, which is faster than to look at some.
std::optional<ValueCounts> countsOf(const Grid& grid, std::size_t stride, std::size_t most,
                                    base::Progress& progress) {
  return grid.visit([&]<class T>(const std::vector<T>& voxels) -> std::optional<ValueCounts> {
    if constexpr (std::is_integral_v<T>) {
      ValueCounts counts = countsOfStored(grid, voxels, progress);
      const bool whole = std::ranges::all_of(
          counts, [](const auto& entry) { return entry.first == std::floor(entry.first); });
      return whole && counts.size() <= most ? std::optional(std::move(counts)) : std::nullopt;
    } else {
      return countsOfRows(grid, stride, most, progress);
    }
  });
}

double backgroundOf(const ValueCounts& counts) {
  const double least = counts.begin()->first, greatest = counts.rbegin()->first;
  const double frequent = std::ranges::max_element(counts, {}, &ValueCounts::value_type::second)->first;
  if (counts.contains(0.0) && (least == 0.0 || frequent == 0.0)) return 0.0;
  return frequent == greatest ? greatest : least;
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

std::optional<ValueCounts> valueCounts(const Grid& grid, std::size_t most, base::Progress& progress) {
  return countsOf(grid, 1, most, progress);
}

std::optional<LabelMap> labelMapOf(const Grid& grid, bool asked, base::Progress& progress) {
  const glm::ivec3 dims = grid.dims();
  const Extent3 extent{dims};
  const std::size_t most = asked ? kMostStatedLabels : kMostLabels;
  const std::size_t stride = std::max<std::size_t>(1, extent.count() / kEnough);
  const auto eachRow = [&](const auto& body) {
    for (std::size_t row = 0; row < extent.rows(); row += stride) {
      progress.throwIfStopped();
      const glm::ivec3 first = extent.firstOfRow(row);
      body(first.y, first.z);
    }
  };
  std::optional<ValueCounts> counts = countsOf(grid, asked ? 1 : stride, most, progress);
  if (!counts || counts->size() < (asked ? 2 : 3)) return std::nullopt;
  const auto mapOf = [](const ValueCounts& all) {
    const double background = backgroundOf(all);
    return LabelMap{background, static_cast<int>(all.size()) - 1,
                    background == all.begin()->first || background == all.rbegin()->first};
  };
  if (asked) return mapOf(*counts);
  const double background = std::ranges::max_element(*counts, {}, &ValueCounts::value_type::second)->first;
  std::vector<double> values;
  for (const auto& [value, count] : *counts) values.push_back(value);

  Neighbours found;
  std::set<double> bodies;  // values of voxels whose neighbours all have the same one
  eachRow([&](int y, int z) {
    for (int x = 0; x < dims.x; ++x) {
      const double here = grid.value(x, y, z);
      if (here != background && insideItsRegion(grid, {x, y, z})) bodies.insert(here);
      if (x + 1 < dims.x) compare(here, grid.value(x + 1, y, z), background, values, found);
      if (y + 1 < dims.y) compare(here, grid.value(x, y + 1, z), background, values, found);
      if (z + 1 < dims.z) compare(here, grid.value(x, y, z + 1), background, values, found);
    }
  });
  const auto part = [](std::size_t of, std::size_t all) {
    return all == 0 ? 0.0 : static_cast<double>(of) / static_cast<double>(all);
  };
  // Counts of integers are those of all rows, bodies those of the rows that were looked at.
  const std::size_t enough = kFrequent * (grid.storedType() == VoxelType::float32 ? 1 : stride);
  std::size_t frequent = 0,
              filled = 0;  // of a scan's values few fill anything: air, a table, what is clipped
  for (const auto& [value, count] : *counts)
    if (value != background && count >= enough) {
      ++frequent;
      filled += bodies.contains(value) ? 1 : 0;
    }
  const bool measures = bodies.size() < 2 || part(found.unequal, found.pairs) > kMostUnequal ||
                        part(found.jumps, found.unequal) < kLeastJumps ||
                        (frequent > 0 && part(filled, frequent) < kLeastBodies);
  if (measures) return std::nullopt;
  if (grid.storedType() == VoxelType::float32 && stride > 1)  // rare labels lie between the rows
    counts = countsOf(grid, 1, most, progress);
  return counts ? std::optional(mapOf(*counts)) : std::nullopt;
}

}  // namespace isolux::volume
