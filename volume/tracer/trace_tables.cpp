#include "volume/tracer/trace_tables.h"

#include <algorithm>
#include <mutex>
#include <type_traits>
#include <variant>

#include "base/huge_pages.h"
#include "volume/parallel/parallel_steps.h"

namespace isolux::volume::tracing {

namespace {

// While they are made: the bins of all voxels, beside what stays.
std::size_t bytesToMake(const Grid& grid) {
  const std::size_t voxels = grid.geometry().voxelCount();
  const std::size_t widened = bytesOf(grid.storedType()) == 1 ? voxels * sizeof(std::int16_t) : 0;
  return CellRanges::bytesOf(grid.dims()) + std::max(voxels, widened);
}

// The tables that are alive. Each holds its grid, so that no two grids are at one place.
class Living {
 public:
  std::shared_ptr<const TraceTables> find(const Grid& grid) {
    const std::lock_guard lock(mutex_);
    return findLocked(grid);
  }
  // Or those that another thread has made in the meantime.
  std::shared_ptr<const TraceTables> add(std::shared_ptr<const TraceTables> made) {
    const std::lock_guard lock(mutex_);
    if (std::shared_ptr<const TraceTables> others = findLocked(made->grid())) return others;
    list_.push_back(made);
    return made;
  }

 private:
  std::shared_ptr<const TraceTables> findLocked(const Grid& grid) {
    std::erase_if(list_, [](const auto& tables) { return tables.expired(); });
    for (const auto& weak : list_)
      if (auto tables = weak.lock(); tables && &tables->grid() == &grid) return tables;
    return nullptr;
  }

  std::mutex mutex_;
  std::vector<std::weak_ptr<const TraceTables>> list_;
};

Living& living() {
  static Living tables;
  return tables;
}

}  // namespace

std::shared_ptr<const TraceTables> TraceTables::of(const std::shared_ptr<const Grid>& grid,
                                                   base::Progress& progress) {
  if (auto tables = living().find(*grid)) return tables;
  return living().add(std::shared_ptr<const TraceTables>(new TraceTables(grid, progress)));
}

TraceTables::TraceTables(std::shared_ptr<const Grid> grid, base::Progress& progress)
    : held_(base::machineMemory().reserve(bytesToMake(*grid), "the tables of light tracing",
                                          "a volume of fewer voxels or gi.mode=off needs less")),
      grid_(std::move(grid)),
      ranges_(*grid_, progress) {
  std::visit(
      [&](const auto& voxels) {
        using T = typename std::decay_t<decltype(voxels)>::value_type;
        if constexpr (sizeof(T) > 1) {
          preferHugePages(voxels.data(), voxels.size() * sizeof(T), progress);
        } else {
          widened_.reserve(voxels.size());
          preferHugePages(widened_.data(), widened_.capacity() * sizeof widened_[0], progress);
          resizeStoppably(widened_, voxels.size(), progress);
          parallelPieces(voxels.size(), std::size_t{1} << 20, progress, {},
                         [&](std::size_t begin, std::size_t end) {
                           for (std::size_t i = begin; i < end; ++i)
                             widened_[i] = voxels[i];  // NOLINT(bugprone-signed-char-misuse): no character
                         });
        }
      },
      grid_->voxels());
  progress.throwIfStopped();
  held_.shrinkTo(bytes());
}

}  // namespace isolux::volume::tracing
