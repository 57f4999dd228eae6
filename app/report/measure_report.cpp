#include "app/report/measure_report.h"

#include <algorithm>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "app/report/curvature_report.h"
#include "base/number_text.h"
#include "base/printable.h"

namespace isolux::app {

namespace {

using nlohmann::ordered_json;

void printRow(std::ostream& out, std::string_view name, const std::string& text) {
  out << name << std::string(name.size() < 14 ? 14 - name.size() : 1, ' ') << base::printable(text) << '\n';
}

std::string positionText(const ordered_json& position) {
  std::string text;
  for (const ordered_json& number : position)
    text += (text.empty() ? "" : ",") + base::shortText(number.get<double>());
  return text;
}

// "12.3 +- 0.4 mm (quadrature 0.1, ...)"
std::string measuredText(const ordered_json& measured, const std::string& unit) {
  if (measured.is_null()) return "none";
  std::string text = base::shortText(measured["value"].get<double>()) + " +- " +
                     base::shortText(measured["error"].get<double>(), 2) + " " + unit;
  if (!measured.contains("parts")) return text;
  std::string parts;
  for (const auto& [name, part] : measured["parts"].items())
    if (part.get<double>() > 0.0)
      parts += (parts.empty() ? "" : ", ") + name + " " + base::shortText(part.get<double>(), 2);
  return parts.empty() ? text : text + " (" + parts + ")";
}

void printDistances(const ordered_json& distances, std::ostream& out) {
  for (const ordered_json& distance : distances) {
    printRow(out, "distance", positionText(distance["from_mm"]) + " to " + positionText(distance["to_mm"]));
    printRow(out, "  straight", measuredText(distance["straight_mm"], "mm"));
    printRow(out, "  along",
             distance.contains("along_surface_reason") ? distance["along_surface_reason"].get<std::string>()
                                                       : measuredText(distance["along_surface_mm"], "mm"));
  }
}

constexpr std::size_t kListedPieces = 10;

void printPieces(const ordered_json& pieces, std::ostream& out) {
  printRow(out, "pieces", std::to_string(pieces.size()));
  for (std::size_t i = 0; i < std::min(pieces.size(), kListedPieces); ++i)
    printRow(
        out, "  " + std::to_string(pieces[i]["id"].get<std::size_t>()),
        measuredText(pieces[i]["volume_mm3"], "mm^3") + ", " + measuredText(pieces[i]["area_mm2"], "mm^2"));
  if (pieces.size() > kListedPieces) printRow(out, "  ...", "--json lists all");
}

}  // namespace

ordered_json vectorOf(glm::dvec3 v) {
  return ordered_json::array({v.x, v.y, v.z});
}

ordered_json vectorsOf(const std::vector<glm::dvec3>& vectors) {
  ordered_json json = ordered_json::array();
  for (const glm::dvec3& v : vectors) json.push_back(vectorOf(v));
  return json;
}

ordered_json measuredJson(const volume::Measured& measured) {
  return {{"value", measured.value}, {"error", measured.error}};
}

ordered_json measuredJson(const volume::Measured& measured, const volume::ErrorParts& parts) {
  ordered_json json = measuredJson(measured);
  json["parts"] = {{"quadrature", parts.quadrature},
                   {"sampling", parts.sampling},
                   {"noise", parts.noise},
                   {"cut", parts.cut},
                   {"slices", parts.slices}};
  return json;
}

std::string openReason(const volume::SurfaceMeasure& surface) {
  if (surface.meetsBorder) return "the inside extends beyond the volume's border";
  return "the inside goes on where voxels are missing";
}

ordered_json surfaceJson(const volume::SurfaceMeasure& surface) {
  ordered_json json;
  json["area_mm2"] = measuredJson(surface.areaMm2, surface.areaParts);
  json["volume_mm3"] = measuredJson(surface.volumeMm3, surface.volumeParts);
  json["volume_per_value_mm3"] = surface.volumePerValue;
  json["cells"] = surface.cells;
  json["open"] = surface.open();
  if (surface.open()) json["open_reason"] = openReason(surface);
  return json;
}

void printMeasures(const ordered_json& json, std::ostream& out) {
  const std::string unit = json["unit"].get<std::string>(), one = unit.empty() ? "unit of value" : unit;
  printRow(out, "isovalue",
           base::shortText(json["isovalue"].get<double>()) + (unit.empty() ? "" : " " + unit) +
               ", inside is " + json["inside"].get<std::string>());
  printRow(out, "area", measuredText(json["area_mm2"], "mm^2"));
  printRow(out, "volume",
           measuredText(json["volume_mm3"], "mm^3") + (json["open"].get<bool>() ? ", open" : ""));
  printRow(out, "", base::shortText(json["volume_per_value_mm3"].get<double>()) + " mm^3 less per " + one);
  if (json.contains("pieces")) printPieces(json["pieces"], out);
  if (json.contains("curvature")) printCurvature(json["curvature"], out);
  if (json.contains("distances")) printDistances(json["distances"], out);
  if (json.contains("angles"))
    for (const ordered_json& angle : json["angles"])
      printRow(out, "angle", measuredText(angle["degrees"], "degrees"));
  if (json.contains("circles"))
    for (const ordered_json& circle : json["circles"])
      printRow(out, "circle",
               "radius " + measuredText(circle["radius_mm"], "mm") + " about " +
                   positionText(circle["centre_mm"]));
  if (json.contains("thicknesses"))
    for (const ordered_json& thickness : json["thicknesses"]) {
      printRow(out, "thickness", "at " + positionText(thickness["point_mm"]));
      printRow(out, "  by ray", measuredText(thickness["ray_mm"], "mm"));
      printRow(out, "  by ball", measuredText(thickness["ball_mm"], "mm"));
    }
}

}  // namespace isolux::app
