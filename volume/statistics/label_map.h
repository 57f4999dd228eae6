// Whether a volume's values are names of regions (a segmentation, an atlas) and measure nothing.
#pragma once

#include <optional>

#include "base/progress.h"
#include "volume/grid.h"

namespace isolux::volume {

struct LabelMap {
  double background = 0.0;  // the most frequent value, data units
  int labels = 0;           // other values, at least 2
};
// Values are taken for labels where they are few whole numbers, where neighbours within the objects are
// mostly equal, where unequal ones jump (a smooth field in steps goes from each value to the next), and where
// at least two of them, and half of the frequent ones, fill more than surfaces (of a mask that was averaged
// only one does, of a scan without noise only air and what is clipped). Nothing for masks of two values,
// which have one isosurface either way. A whole grid. Throws Error{interrupted}.
// `asked`: somebody says that they are, and only whole numbers are asked for.
std::optional<LabelMap> labelMapOf(const Grid& grid, bool asked, const base::Progress& progress);

}  // namespace isolux::volume
