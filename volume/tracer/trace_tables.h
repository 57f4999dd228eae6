// What rays through a grid skip by and read, whichever side is inside: made once for all tracers of the grid
// that are alive at the same time.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/memory_budget.h"
#include "base/progress.h"
#include "volume/grid.h"
#include "volume/skip/cell_ranges.h"

namespace isolux::volume::tracing {

class TraceTables {
 public:
  // Those of a tracer that is alive, or new ones, made on all threads. Throws Error: interrupted; memory,
  // before anything is made. Any thread; two that ask at once may both make them, and keep the same.
  static std::shared_ptr<const TraceTables> of(const std::shared_ptr<const Grid>& grid,
                                               base::Progress& progress);
  TraceTables(const TraceTables&) = delete;
  TraceTables& operator=(const TraceTables&) = delete;

  const Grid& grid() const { return *grid_; }
  const CellRanges& ranges() const { return ranges_; }
  const std::vector<std::int16_t>& widened() const { return widened_; }  // the voxels of 8-bit grids
  std::size_t bytes() const { return ranges_.bytes() + widened_.size() * sizeof(std::int16_t); }

 private:
  TraceTables(std::shared_ptr<const Grid> grid, base::Progress& progress);

  base::MemoryBudget::Held held_;
  std::shared_ptr<const Grid> grid_;
  CellRanges ranges_;
  std::vector<std::int16_t> widened_;
};

}  // namespace isolux::volume::tracing
