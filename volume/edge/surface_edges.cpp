#include "volume/edge/surface_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/quantiles.h"
#include "scene/rules/needs.h"
#include "volume/parallel/parallel_loops.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::volume {

EdgeQuestion edgeQuestion(const scene::Scene& scene, const GridGeometry& geometry,
                          const glm::dvec3& noiseBlur) {
  const double scaleMm = scene::derivativesScale(scene);
  return {.searchMm = scene.edge.search.value_or(automaticEdgeSearch(geometry, scaleMm)),
          .contrast = scene.edge.contrast,
          .noise = scene.derivatives.noise.value_or(0.0),
          .noiseBlur = noiseBlur,
          .outward = scene.isosurface.inside == scene::Inside::above ? -1.0 : 1.0};
}

SurfaceEdges::SurfaceEdges(std::shared_ptr<const PreparedVolume> volume, const scene::Scene& scene,
                           base::Progress& progress)
    : volume_(std::move(volume)) {
  EdgeField field{scene.derivatives.field};
  const double scaleMm = scene::derivativesScale(scene);
  if (scaleMm > 0.0) {
    scaled_ = volume_->cubicFields->make(field.field, scaleMm, progress);
    field.scaled = scaled_.get();
  } else if (field.field == scene::Field::cubic_interpolating) {
    cubic_ = volume_->cubicFields->make(field.field, progress);
    field.coefficients = &*cubic_->coefficients;
  }
  const Grid& grid = volume_->grid();
  const glm::dvec3 blur = volume_->derivativeChoices->noise(progress).correlation;
  finder_.emplace(grid, field, edgeQuestion(scene, grid.geometry(), blur));
}

EdgeStatistics edgeStatistics(const EdgeFinder& finder, std::span<const VisiblePoint> points) {
  std::vector<Edge> edges(points.size());
  parallelEach(points.size(), [&](std::size_t i) { edges[i] = finder.at(points[i].voxel); });
  EdgeStatistics out;
  out.points = points.size();
  if (points.empty()) return out;
  std::vector<double> offsets, distances, strengths;
  for (const Edge& edge : edges) {
    strengths.push_back(edge.strength);
    if (edge.offsetMm) offsets.push_back(*edge.offsetMm);
    distances.push_back(edge.offsetMm ? std::abs(*edge.offsetMm) : std::numeric_limits<double>::infinity());
  }
  out.without = points.size() - offsets.size();
  out.strength = base::lowerQuantile(strengths, 0.5);
  const auto within = [&](double part) {
    const double distance = base::lowerQuantile(distances, part);
    return std::isfinite(distance) ? std::optional(distance) : std::nullopt;
  };
  out.within50 = within(0.5);
  out.within90 = within(0.9);
  if (offsets.empty()) return out;
  out.low = base::lowerQuantile(offsets, 0.05);
  out.median = base::lowerQuantile(offsets, 0.5);
  out.high = base::lowerQuantile(offsets, 0.95);
  return out;
}

}  // namespace isolux::volume
