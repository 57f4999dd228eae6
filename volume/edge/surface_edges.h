// How far an isosurface lies from the edge of its object, by what a scene says of it: at points, and as a
// whole.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "volume/derived/cubic_fields.h"
#include "volume/edge/edge_finder.h"
#include "volume/statistics/visible_points.h"

namespace isolux::volume {

struct PreparedVolume;

// The scene's noise, scale and isovalue are known (app::completeFields, DerivativeChoices::complete).
EdgeQuestion edgeQuestion(const scene::Scene& scene, const GridGeometry& geometry,
                          const glm::dvec3& noiseBlur);

class SurfaceEdges {
 public:
  // Makes the field where it is not there yet. Keeps the volume. Throws Error{interrupted}.
  SurfaceEdges(std::shared_ptr<const PreparedVolume> volume, const scene::Scene& scene,
               base::Progress& progress);
  const EdgeFinder& finder() const { return *finder_; }  // whose at() any thread may call

 private:
  std::shared_ptr<const PreparedVolume> volume_;
  std::shared_ptr<const ScaledField> scaled_;
  std::shared_ptr<const CubicField> cubic_;
  std::optional<EdgeFinder> finder_;
};

// Of points of a surface. Distances, mm: of all points, those without an edge are infinitely far.
struct EdgeStatistics {
  std::size_t points = 0, without = 0;
  std::optional<double> within50, within90;  // half of the points, 90 %, lie no further from an edge
  std::optional<double> low, median, high;  // of signed offsets that there are: the 5 %, 50 %, 95 % quantiles
  double strength = 0.0;                    // the median
};
EdgeStatistics edgeStatistics(const EdgeFinder& finder, std::span<const VisiblePoint> points);

}  // namespace isolux::volume
