// Whether a volume's values are names of regions (a segmentation, an atlas) and measure nothing.
#pragma once

#include <cstddef>
#include <map>
#include <optional>

#include "base/progress.h"
#include "volume/grid.h"

namespace isolux::volume {

// Returns how many voxels have each value, data units; missing voxels do not count. Returns nullopt if a
// value is no whole number, or more than `most` differ. A whole grid. Throws Error{interrupted}.
using ValueCounts = std::map<double, std::size_t>;
std::optional<ValueCounts> valueCounts(const Grid& grid, std::size_t most, base::Progress& progress);

inline constexpr std::size_t kMostLabels = 4096;  // that are found by themselves; atlases have hundreds
inline constexpr std::size_t kMostStatedLabels = 65536;  // where somebody says so

struct LabelMap {
  // 0 if it is the least or the most frequent value; else the most frequent value if it is the least or the
  // greatest; else the least. Data units.
  double background = 0.0;
  int labels = 0;           // other values
  bool isOutermost = true;  // no other value lies below the background, or none above it
};
// Values are taken for labels where they are few whole numbers, where neighbours within the objects are
// mostly equal, where unequal ones jump (a smooth field in steps goes from each value to the next), and where
// at least two of them, and half of the frequent ones, fill more than surfaces (of a mask that was averaged
// only one does, of a scan without noise only air and what is clipped). Nothing for masks of two values,
// which have one isosurface either way. A whole grid. Throws Error{interrupted}.
// `asked`: somebody says that they are, and only two to 65 536 whole numbers are asked for.
std::optional<LabelMap> labelMapOf(const Grid& grid, bool asked, base::Progress& progress);

}  // namespace isolux::volume
