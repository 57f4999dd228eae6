#include "app/report/measure_report.h"

#include <algorithm>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/report/curvature_report.h"
#include "app/report/notes.h"
#include "app/report/piece_report.h"
#include "base/number_text.h"
#include "base/words.h"
#include "scene/settings/choice_names.h"
#include "volume/pieces/shown_pieces.h"

namespace isolux::app {

namespace {

using nlohmann::ordered_json;

std::string positionText(const ordered_json& position) {
  return base::joined(position, ",",
                      [](const ordered_json& number) { return base::shortText(number.get<double>()); });
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

// Whether a piece that is shown has a corner of the cell.
bool holdsShown(const volume::Pieces& pieces, const std::vector<bool>& shown, glm::ivec3 cell) {
  for (int i = 0; i < 8; ++i) {
    const std::uint32_t id = pieces.ofVoxel(cell + glm::ivec3(i & 1, i >> 1 & 1, i >> 2));
    if (id < shown.size() && shown[id]) return true;
  }
  return false;
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

SizedSurface sizedSurface(const volume::PreparedVolume& prepared, const scene::Scene& scene,
                          volume::SurfaceQuestion question, base::Progress& progress) {
  const bool hides = volume::hidesPieces(scene.pieces);
  if (question.box && !hides)
    return {measureSurface(prepared.grid(), *prepared.blocks, question, progress), {}};
  const auto pieces = prepared.pieces->at(question.isovalue, question.inside, progress);
  std::vector<bool> shown;
  if (hides) shown = prepared.pieces->shown(*pieces, scene.pieces, progress);
  if (question.box) {
    question.keeps = [&](glm::ivec3 cell) { return holdsShown(*pieces, shown, cell); };
    return {measureSurface(prepared.grid(), *prepared.blocks, question, progress), {}};
  }
  const volume::PieceMeasures measures = measurePieces(*pieces, *prepared.blocks, question, shown, progress);
  SizedSurface sized{measures.whole, {}};
  for (std::size_t id = 0; id < measures.pieces.size(); ++id)
    if (shown.empty() || shown[id]) sized.pieces.emplace(id, measures.pieces[id]);
  return sized;
}

ordered_json surfaceJson(const volume::PreparedVolume& prepared, const volume::SurfaceQuestion& question,
                         const SizedSurface& sized, const std::optional<std::string>& doubt) {
  const volume::SurfaceMeasure& surface = sized.whole;
  ordered_json json{{"isovalue", question.isovalue},
                    {"unit", prepared.volume.unit},
                    {"inside", scene::choiceName(question.inside)},
                    {"noise", question.noise.at(question.isovalue)}};
  if (doubt) json["doubt"] = *doubt;
  json["area_mm2"] = measuredJson(surface.areaMm2, surface.areaParts);
  json["volume_mm3"] = measuredJson(surface.volumeMm3, surface.volumeParts);
  json["volume_per_value_mm3"] = surface.volumePerValue;
  json["cells"] = surface.cells;
  json["open"] = surface.open();
  if (surface.open()) json["open_reason"] = openReason(surface);
  if (question.box) return json;
  json["pieces"] = ordered_json::array();
  for (const auto& [id, piece] : sized.pieces) json["pieces"].push_back(pieceJson(id, piece));
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
