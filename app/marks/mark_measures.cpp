// Distances, ways, angles, circles, thicknesses and pieces of app/marks/mark_evaluator.h.

#include <glm/geometric.hpp>

#include "app/marks/mark_evaluator.h"
#include "base/number_text.h"
#include "volume/measure/geodesic.h"
#include "volume/measure/points.h"
#include "volume/measure/thickness.h"

namespace isolux::app {

namespace {

using volume::Measured;

MarkQuantity quantityOf(const std::string& name, const Measured& measured, const char* unit) {
  return {name, measured.value, measured.error, unit};
}

// A single segment is the whole.
void addSegments(const std::vector<Measured>& segments, const std::string& name, MarkReport& report) {
  Measured sum;
  for (const Measured& segment : segments) {
    sum.value += segment.value;
    sum.error += segment.error;
  }
  report.quantities.push_back(quantityOf(name, sum, "mm"));
  if (segments.size() < 2) return;
  for (std::size_t i = 0; i < segments.size(); ++i)
    report.quantities.push_back(
        quantityOf(name + '_' + std::to_string(i + 1) + '_' + std::to_string(i + 2), segments[i], "mm"));
}

}  // namespace

void MarkEvaluator::distance(const std::vector<Placed>& points, MarkReport& report) const {
  std::vector<Measured> segments;
  for (std::size_t i = 1; i < points.size(); ++i)
    segments.push_back(straightDistance(points[i - 1].at, points[i].at));
  addSegments(segments, "straight", report);
}

void MarkEvaluator::path(Surface& surface, const std::vector<Placed>& points, MarkReport& report,
                         base::Progress& progress) const {
  const volume::SurfaceGraph& graph = graphOf(surface, progress);
  std::vector<Measured> segments;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto way =
        geodesic(surface.of, graph, points[i - 1].onSurface->world, points[i].onSurface->world, progress);
    if (!way) {
      report.problem =
          "no path along the surface from point " + std::to_string(i) + " to point " + std::to_string(i + 1);
      report.line.clear();
      return;
    }
    segments.push_back(way->lengthMm);
    report.line.insert(report.line.end(), way->path.begin() + (report.line.empty() ? 0 : 1), way->path.end());
  }
  addSegments(segments, "along_surface", report);
  double straight = 0.0, error = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Measured part = straightDistance(points[i - 1].at, points[i].at);
    straight += part.value;
    error += part.error;
  }
  report.quantities.push_back({"straight", straight, error, "mm"});
}

void MarkEvaluator::angle(const std::vector<Placed>& points, MarkReport& report) const {
  const auto degrees = points.size() == 3
                           ? angleDegrees(points[0].at, points[1].at, points[2].at)
                           : lineAngleDegrees(points[0].at, points[1].at, points[2].at, points[3].at);
  if (degrees)
    report.quantities.push_back(quantityOf("angle", *degrees, "°"));
  else
    report.problem = "two of the points coincide";
}

void MarkEvaluator::circle(const std::vector<Placed>& points, MarkReport& report) const {
  const auto circle = circleThrough(points[0].at, points[1].at, points[2].at);
  if (!circle) {
    report.problem = "the points are on a line";
    return;
  }
  report.quantities.push_back(quantityOf("radius", circle->radiusMm, "mm"));
  report.centre = circle->centre;
  report.normal = circle->normal;
  const char* const names[] = {"centre_x", "centre_y", "centre_z"};
  for (int axis = 0; axis < 3; ++axis)
    report.quantities.push_back({names[axis], circle->centre[axis], {}, "mm"});
}

void MarkEvaluator::thickness(Surface& surface, const Placed& point, MarkReport& report,
                              base::Progress& progress) const {
  const auto ray = thicknessByRay(surface.of, *volume_->blocks, *point.onSurface);
  const auto ball = inscribedBall(surface.of, graphOf(surface, progress), *point.onSurface);
  if (ray) {
    report.quantities.push_back(quantityOf("ray", ray->mm, "mm"));
    report.line = {point.onSurface->world, ray->exit};
  }
  if (ball) {
    report.quantities.push_back(quantityOf("ball", ball->diameterMm, "mm"));
    report.centre = ball->centre;
  }
  if (!ray && !ball) report.problem = "the inside behind the point extends beyond the data";
}

void MarkEvaluator::piece(Surface& surface, const Placed& point, MarkReport& report,
                          base::Progress& progress) const {
  if (!surface.pieces) surface.pieces = volume_->pieces->at(surface.of.isovalue, surface.of.inside, progress);
  const volume::GridGeometry& geometry = surface.of.grid.geometry();
  const glm::dmat4 voxelFromWorld = geometry.voxelFromWorld();
  const auto pieceAt = [&](glm::dvec3 world) {
    return surface.pieces->ofPoint(glm::dvec3(voxelFromWorld * glm::dvec4(world, 1.0)));
  };
  std::uint32_t id = pieceAt(point.at.world);
  // A point of the surface is inside, or by a rounding outside.
  if (point.onSurface)
    for (const double depth : {0.0, 0.01, 0.1, 0.3, 0.6, 1.0}) {
      if (id != volume::Pieces::kNone) break;
      const double least = geometry.leastSpacingMm();
      id = pieceAt(point.onSurface->world - depth * least * point.onSurface->facet);
    }
  if (id == volume::Pieces::kNone) {
    report.problem =
        "the point is in no connected component at isovalue " + base::shortText(surface.of.isovalue);
    return;
  }
  if (!surface.sizes)
    surface.sizes = measurePieces(
        *surface.pieces, *volume_->blocks,
        {surface.of.isovalue, surface.of.inside, std::nullopt, surface.of.noise, {}}, {}, progress);
  const volume::PieceMeasure& found = surface.sizes->pieces[id];
  report.quantities.push_back(quantityOf("volume", found.surface.volumeMm3, "mm³"));
  report.quantities.push_back(quantityOf("area", found.surface.areaMm2, "mm²"));
  report.quantities.push_back({"piece", static_cast<double>(id), {}, ""});
  report.quantities.push_back({"pieces", static_cast<double>(surface.sizes->pieces.size()), {}, ""});
  if (found.surface.open()) report.notes.push_back("the component is open: it extends beyond the data");
}

}  // namespace isolux::app
