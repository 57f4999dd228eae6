#include "volume/tracer/trace_tables.h"

#include <algorithm>
#include <mutex>
#include <type_traits>

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

}  // namespace

std::shared_ptr<const TraceTables> TraceTables::of(const std::shared_ptr<const Grid>& grid,
                                                   base::Progress& progress) {
  // Each holds its grid, so that no two grids are at one place.
  static std::vector<std::weak_ptr<const TraceTables>> alive;
  static std::mutex mutex;
  const auto find = [&]() -> std::shared_ptr<const TraceTables> {
    std::erase_if(alive, [](const auto& tables) { return tables.expired(); });
    for (const auto& weak : alive)
      if (auto tables = weak.lock(); tables && &tables->grid() == grid.get()) return tables;
    return nullptr;
  };
  {
    const std::lock_guard lock(mutex);
    if (auto tables = find()) return tables;
  }
  const std::shared_ptr<const TraceTables> made(new TraceTables(grid, progress));
  const std::lock_guard lock(mutex);
  if (auto others = find()) return others;  // that another thread has made in the meantime
  alive.push_back(made);
  return made;
}

TraceTables::TraceTables(std::shared_ptr<const Grid> grid, base::Progress& progress)
    : held_(base::machineMemory().reserve(bytesToMake(*grid), "the tables of light tracing",
                                          "a volume of fewer voxels or gi.mode=off needs less")),
      grid_(std::move(grid)),
      ranges_(*grid_, progress) {
  grid_->visit([&](const auto& voxels) {
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
  });
  progress.throwIfStopped();
  held_.shrinkTo(bytes());
}

}  // namespace isolux::volume::tracing
