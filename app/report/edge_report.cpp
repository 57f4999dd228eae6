#include "app/report/edge_report.h"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/picture/field_job.h"
#include "base/number_text.h"
#include "scene/rules/automatic.h"
#include "scene/rules/needs.h"

namespace isolux::app {

namespace {

nlohmann::ordered_json numberOrNull(const std::optional<double>& number) {
  return number ? nlohmann::ordered_json(*number) : nlohmann::ordered_json(nullptr);
}

std::string millimetres(double mm) {
  return base::shortText(mm, 2) + " mm";
}

}  // namespace

EdgeReport measureEdges(scene::Scene scene, const std::shared_ptr<const volume::PreparedVolume>& volume,
                        base::Progress& progress) {
  EdgeReport report{scene::resolve(std::move(scene), volume->facts), 0.0, {}};
  completeFields(report.scene, *volume, true, progress);
  const volume::SurfaceEdges edges(volume, report.scene, progress);
  report.searchMm = report.scene.edge.search.value_or(
      volume::automaticEdgeSearch(volume->grid().geometry(), scene::derivativesScale(report.scene)));
  report.edges = volume::edgeStatistics(
      edges.finder(), volume::visiblePoints(volume->grid(), *volume->blocks, *report.scene.isosurface.value));
  return report;
}

nlohmann::ordered_json edgeJson(const EdgeReport& report) {
  const volume::EdgeStatistics& edges = report.edges;
  nlohmann::ordered_json json;
  json["isovalue"] = *report.scene.isosurface.value;
  json["scale_mm"] = scene::derivativesScale(report.scene);
  json["search_mm"] = report.searchMm;
  json["contrast"] = report.scene.edge.contrast;
  json["points"] = edges.points;
  json["without_edge"] = edges.without;
  json["half_within_mm"] = numberOrNull(edges.within50);
  json["90_percent_within_mm"] = numberOrNull(edges.within90);
  json["offset_mm"] = {{"5_percent", numberOrNull(edges.low)},
                       {"median", numberOrNull(edges.median)},
                       {"95_percent", numberOrNull(edges.high)}};
  json["median_strength"] = edges.strength;
  return json;
}

std::string edgeText(const EdgeReport& report) {
  const volume::EdgeStatistics& edges = report.edges;
  const std::string surface = "the surface of " + base::shortText(*report.scene.isosurface.value);
  if (edges.points == 0) return surface + " is empty";
  std::string text;
  if (edges.within50)
    text += "half of " + surface + " is within " + millimetres(*edges.within50) + " of an edge, ";
  if (edges.within90) text += "90 % within " + millimetres(*edges.within90) + ", ";
  const double without = 100.0 * static_cast<double>(edges.without) / static_cast<double>(edges.points);
  text += base::shortText(without, 2) + " % " + (edges.within50 ? "" : "of " + surface + " ") +
          "have none within " + millimetres(report.searchMm);
  if (edges.median)
    text += "; the edge is " + millimetres(std::abs(*edges.median)) +
            (*edges.median < 0.0 ? " inside" : " outside") + " (median), from " +
            base::shortText(*edges.low, 2) + " to " + millimetres(*edges.high) + " (5 % to 95 %)";
  return text;
}

}  // namespace isolux::app
