#include "app/report/measure_points.h"

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "app/files/json_text.h"
#include "app/files/number_rows.h"
#include "app/report/measure_report.h"
#include "base/error.h"
#include "base/number_text.h"
#include "volume/measure/geodesic.h"
#include "volume/measure/points.h"
#include "volume/measure/thickness.h"

namespace isolux::app {

namespace {

using nlohmann::ordered_json;
using volume::SurfaceOf;
using volume::SurfacePoint;
using volume::UncertainPoint;

std::string pointText(glm::dvec3 p) {
  return base::shortText(p.x) + "," + base::shortText(p.y) + "," + base::shortText(p.z);
}

// A position is one of the surface where that passes within half a voxel's diagonal; then it may be wrong by
// what the surface is.
UncertainPoint uncertain(const SurfaceOf& surface, glm::dvec3 world) {
  const auto near = nearestPoint(surface, world);
  const double reach = 0.5 * glm::length(surface.grid.geometry().spacingMm());
  if (!near || glm::length(near->world - world) > reach) return {world, 0.0};
  return {world, offsetError(*near)};
}

SurfacePoint pointOfSurface(const MeasuredSurface& measured, glm::dvec3 world, const std::string& option) {
  if (auto near = nearestPoint(measured.surface, world)) return *near;
  base::throwInput(measured.file, option,
                   "no isosurface of " + base::shortText(measured.surface.isovalue) +
                       " within three voxels of " + pointText(world));
}

}  // namespace

const volume::SurfaceGraph& MeasuredSurface::graphOnce(base::Progress& progress) {
  if (!graph) graph = surfaceGraph(prepared.grid(), *prepared.blocks, surface.isovalue, progress);
  return *graph;
}

ordered_json distanceJson(MeasuredSurface& measured, const std::string& text, base::Progress& progress) {
  const auto points = parsePoints(text, "--distance", 2, 2);
  const SurfaceOf& surface = measured.surface;
  const volume::Measured straight =
      straightDistance(uncertain(surface, points[0]), uncertain(surface, points[1]));
  ordered_json json{{"from_mm", points[0]}, {"to_mm", points[1]}, {"straight_mm", measuredJson(straight)}};
  const auto from = nearestPoint(surface, points[0]), to = nearestPoint(surface, points[1]);
  json["along_surface_mm"] = nullptr;
  if (!from || !to) {
    json["along_surface_reason"] = "no isosurface within three voxels of " + pointText(points[from ? 1 : 0]);
    return json;
  }
  const auto way = geodesic(surface, measured.graphOnce(progress), from->world, to->world, progress);
  if (!way) {
    json["along_surface_reason"] = "no path along the surface between the points";
    return json;
  }
  json["along_surface_mm"] = measuredJson(way->lengthMm, way->parts);
  json["along_surface_from_mm"] = from->world;
  json["along_surface_to_mm"] = to->world;
  json["path_mm"] = way->path;
  return json;
}

ordered_json angleJson(const MeasuredSurface& measured, const std::string& text) {
  const auto points = parsePoints(text, "--angle", 3, 4);
  std::vector<UncertainPoint> at;
  at.reserve(points.size());
  for (const glm::dvec3& point : points) at.push_back(uncertain(measured.surface, point));
  const auto angle =
      at.size() == 3 ? angleDegrees(at[0], at[1], at[2]) : dihedralDegrees(at[0], at[1], at[2], at[3]);
  if (!angle) base::throwUsage("", "--angle", "has points on a line or in one place: " + text);
  return {{"points_mm", points}, {"degrees", measuredJson(*angle)}};
}

ordered_json circleJson(const MeasuredSurface& measured, const std::string& text) {
  const auto points = parsePoints(text, "--circle", 3, 3);
  const auto circle =
      circleThrough(uncertain(measured.surface, points[0]), uncertain(measured.surface, points[1]),
                    uncertain(measured.surface, points[2]));
  if (!circle) base::throwUsage("", "--circle", "has its points on a line: " + text);
  return {{"points_mm", points},
          {"radius_mm", measuredJson(circle->radiusMm)},
          {"centre_mm", circle->centre},
          {"normal", circle->normal}};
}

ordered_json thicknessJson(MeasuredSurface& measured, const std::string& text, base::Progress& progress) {
  const glm::dvec3 world = parsePoints(text, "--thickness", 1, 1)[0];
  const SurfacePoint point = pointOfSurface(measured, world, "--thickness");
  ordered_json json{{"point_mm", point.world}, {"normal", point.normal}};
  const auto ray = thicknessByRay(measured.surface, *measured.prepared.blocks, point);
  const auto ball = inscribedBall(measured.surface, measured.graphOnce(progress), point);
  for (const char* key : {"ray_mm", "exit_mm", "ball_mm", "centre_mm", "touches_mm"}) json[key] = nullptr;
  if (ray) json.update({{"ray_mm", measuredJson(ray->mm)}, {"exit_mm", ray->exit}});
  if (ball)
    json.update({{"ball_mm", measuredJson(ball->diameterMm)},
                 {"centre_mm", ball->centre},
                 {"touches_mm", ball->touches}});
  return json;
}

}  // namespace isolux::app
