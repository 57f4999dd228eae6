#include "volume/prepared/still_hits.h"

#include <vector>

#include "volume/statistics/spline_residual.h"
#include "volume/statistics/visible_points.h"

namespace isolux::volume {

namespace {

constexpr std::size_t kPointsRead = 800;

}  // namespace

bool StillHits::gains(double share) const {
  return !givenUp_ && share > kManyBesideSpline;
}

std::optional<double> StillHits::find(double isovalue) const {
  if (!grid_->isWhole()) return 0.0;  // no spline is made of voxels that stay in their file
  return shares_.find(isovalue);
}

double StillHits::measure(double isovalue, base::Progress& progress) const {
  if (!grid_->isWhole()) return 0.0;
  return shares_.get(isovalue, [&] {
    std::vector<glm::dvec3> points;
    for (const VisiblePoint& point : visiblePoints(*grid_, *blocks_, isovalue, kPointsRead))
      points.push_back(point.voxel);
    progress.throwIfStopped();
    const double share = shareBesideSpline(*grid_, points);
    progress.throwIfStopped();
    return share;
  });
}

}  // namespace isolux::volume
