// White matter of a brain, told by the values deep in the body.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "base/progress.h"
#include "volume/grid.h"

namespace isolux::volume {

// White matter of an MR scan, data units: its border to grey matter, and its mean.
struct WhiteMatter {
  double border = 0.0, mean = 0.0;
};

// Finds the white matter in a T1 scan of a head or of a brain alone. It looks at every second voxel along
// each axis that lies at least a fifth of the greatest depth deep in the body above `skin` (body.h): the
// classes of Otsu's two thresholds (1979) are fluid, grey and white matter. Nothing where the brightest is
// not from a quarter to six tenths of them, or the mean of the middle one not from 0.72 to 0.92 of its: in
// other scans. Data units.
std::optional<WhiteMatter> whiteMatterOf(const Grid& grid, double skin, base::Progress& progress);

// The same, looked for when it is first asked for: a fifth of a second in a scan of a head. Any thread.
class KeptWhiteMatter {
 public:
  explicit KeptWhiteMatter(std::optional<WhiteMatter> known) : found_(known) {}
  KeptWhiteMatter(std::shared_ptr<const Grid> grid, double skin) : grid_(std::move(grid)), skin_(skin) {}
  const std::optional<WhiteMatter>& get() const;

 private:
  std::shared_ptr<const Grid> grid_;  // null: known
  double skin_ = 0.0;
  mutable std::once_flag looked_;
  mutable std::optional<WhiteMatter> found_;
};

}  // namespace isolux::volume
