#include "volume/prepared/still_hits.h"

#include <algorithm>

#include "volume/statistics/spline_gap.h"
#include "volume/statistics/visible_points.h"

namespace isolux::volume {

namespace {

constexpr std::size_t kPointsRead = 800, kKept = 64;

}  // namespace

bool StillHits::gains(double share) const {
  return !givenUp_ && share > kManyBesideSpline;
}

std::optional<double> StillHits::find(double isovalue) const {
  if (!grid_->isWhole()) return 0.0;  // no spline is made of voxels that stay in their file
  const std::lock_guard lock(mutex_);
  const auto found =
      std::find_if(kept_.begin(), kept_.end(), [&](const Kept& kept) { return kept.isovalue == isovalue; });
  return found == kept_.end() ? std::nullopt : std::optional(found->share);
}

double StillHits::measure(double isovalue, base::Progress& progress) const {
  if (const auto share = find(isovalue)) return *share;
  std::vector<glm::dvec3> points;
  for (const VisiblePoint& point : visiblePoints(*grid_, *blocks_, isovalue, kPointsRead))
    points.push_back(point.voxel);
  progress.throwIfStopped();
  const double share = shareBesideSpline(*grid_, points);
  progress.throwIfStopped();
  const std::lock_guard lock(mutex_);
  if (kept_.size() == kKept) kept_.erase(kept_.begin());
  kept_.push_back({isovalue, share});
  return share;
}

}  // namespace isolux::volume
