// Whether a surface gains from hits of the spline through the samples, which pictures at rest then take
// (picture.rest_hits): measured at points that can be seen, once for each isovalue.
//
// All members may be called from any thread; nobody waits for another's work.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "volume/grid.h"
#include "volume/skip/min_max_blocks.h"

namespace isolux::volume {

class StillHits {
 public:
  StillHits(std::shared_ptr<const Grid> grid, std::shared_ptr<const MinMaxBlocks> blocks)
      : grid_(std::move(grid)), blocks_(std::move(blocks)) {}

  // The share of what can be seen of the isosurface that lies visibly beside the spline's (spline_gap.h); 0
  // without a surface. `measure` takes some tens of milliseconds. Throws Error{interrupted}.
  std::optional<double> find(double isovalue) const;
  double measure(double isovalue, base::Progress& progress) const;

  // The spline's field did not fit into memory: nothing gains from it any more.
  void giveUp() const { givenUp_ = true; }
  // The spline is worth its time.
  bool gains(double share) const;

 private:
  struct Kept {
    double isovalue, share;
  };
  std::shared_ptr<const Grid> grid_;
  std::shared_ptr<const MinMaxBlocks> blocks_;
  mutable std::atomic<bool> givenUp_{false};
  mutable std::mutex mutex_;        // held for moments
  mutable std::vector<Kept> kept_;  // the latest last
};

}  // namespace isolux::volume
