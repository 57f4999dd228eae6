// What rays of one isovalue skip by where some of its pieces are hidden: made once for a tracer and that of
// the other side.
#pragma once

#include <memory>

#include "base/memory_budget.h"
#include "base/progress.h"
#include "volume/grid.h"
#include "volume/hit/shown_cells.h"
#include "volume/skip/cell_ranges.h"
#include "volume/visible/hidden_pieces.h"

namespace isolux::volume::tracing {

class HiddenTable {
 public:
  // Multithreaded. Throws Error: interrupted; memory, before anything is made.
  HiddenTable(std::shared_ptr<const Grid> grid, HiddenOfSurface surface, base::Progress& progress)
      : held_(base::machineMemory().reserve(
            CellRanges::bytesOf(grid->dims()) + grid->geometry().voxelCount(),
            "the tables of light tracing with hidden components",
            "a volume of fewer voxels, showing all components or gi.mode=off needs less")),
        grid_(std::move(grid)),
        surface_(std::move(surface)),
        level_(InsideLevel::of(*grid_, surface_.isovalue, surface_.inside)),
        ranges_(*grid_, progress, surface_.voxels.get(), level_.high),
        shown_(*grid_, surface_.voxels.get(), surface_.isovalue, surface_.inside) {
    held_.shrinkTo(ranges_.bytes());
  }
  HiddenTable(const HiddenTable&) = delete;
  HiddenTable& operator=(const HiddenTable&) = delete;

  const HiddenOfSurface& surface() const { return surface_; }
  float isovalue() const { return level_.level; }  // of rays, stored units
  const CellRanges& ranges() const { return ranges_; }
  const ShownCells& shown() const { return shown_; }

 private:
  base::MemoryBudget::Held held_;
  std::shared_ptr<const Grid> grid_;
  HiddenOfSurface surface_;
  InsideLevel level_;
  CellRanges ranges_;
  ShownCells shown_;
};

}  // namespace isolux::volume::tracing
