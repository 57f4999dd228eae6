#include "app/report/piece_report.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/files/json_text.h"
#include "app/report/measure_report.h"
#include "app/report/notes.h"
#include "base/number_text.h"
#include "base/words.h"
#include "scene/settings/choice_names.h"
#include "volume/measure/voxel_noise.h"
#include "volume/pieces/piece_seeds.h"

namespace isolux::app {

namespace {

using nlohmann::ordered_json;

constexpr std::size_t kTableRows = 20;

// Without an exponent where whole numbers say enough.
std::string plainText(double number, int digits) {
  return std::abs(number) >= std::pow(10.0, digits) ? std::to_string(std::llround(number))
                                                    : base::shortText(number, digits);
}

// Two decimals: a hundredth of a millimetre.
std::string pieceAtText(const ordered_json& position) {
  return base::joined(position, ",", [](const ordered_json& number) {
    return base::shortText(std::round(100.0 * number.get<double>()) / 100.0);
  });
}

std::vector<std::string> rowOf(const ordered_json& piece) {
  return {std::to_string(piece["id"].get<std::size_t>()) + (piece["shown"].get<bool>() ? "" : " hidden"),
          withErrorText(piece["volume_mm3"]),
          withErrorText(piece["area_mm2"]),
          std::to_string(piece["voxels"].get<std::size_t>()),
          boundsText(piece["bounds_mm"]),
          pieceAtText(piece["seed_mm"])};
}

}  // namespace

std::string withErrorText(const ordered_json& measured) {
  return plainText(measured["value"].get<double>(), 6) + " +- " +
         plainText(measured["error"].get<double>(), 2);
}

std::string boundsText(const ordered_json& bounds) {
  return pieceAtText(bounds[0]) + " to " + pieceAtText(bounds[1]);
}

ordered_json pieceJson(std::size_t id, const volume::PieceMeasure& piece) {
  return {{"id", id},
          {"volume_mm3", measuredJson(piece.surface.volumeMm3)},
          {"area_mm2", measuredJson(piece.surface.areaMm2)},
          {"bounds_mm", {piece.bounds.lowMm, piece.bounds.highMm}},
          {"open", piece.surface.open()}};
}

ordered_json piecesJson(const volume::PreparedVolume& prepared, const scene::Scene& scene,
                        base::Progress& progress) {
  const double isovalue = scene.surfaces.front().value.value();
  const auto pieces = prepared.pieces->at(isovalue, scene.isosurface.inside, progress);
  const volume::SurfaceQuestion question{
      isovalue, scene.isosurface.inside, std::nullopt, volume::voxelNoise(prepared, scene, progress), {}};
  const volume::PieceMeasures measures = measurePieces(*pieces, *prepared.blocks, question, {}, progress);
  const std::vector<glm::ivec3> seeds = pieceSeeds(*pieces, progress);
  const std::vector<bool> shown = prepared.pieces->shown(*pieces, scene.pieces, progress);
  ordered_json list = ordered_json::array();
  for (std::size_t id = 0; id < measures.pieces.size(); ++id) {
    ordered_json piece = pieceJson(id, measures.pieces[id]);
    piece["voxels"] = pieces->list()[id].voxels;
    piece["seed_mm"] = prepared.grid().geometry().worldOf(seeds[id]);
    piece["shown"] = static_cast<bool>(shown[id]);
    list.push_back(std::move(piece));
  }
  return {{"isovalue", isovalue},
          {"inside", scene::choiceName(scene.isosurface.inside)},
          {"count", list.size()},
          {"list", std::move(list)}};
}

void printPieceTable(const ordered_json& json, const volume::PreparedVolume& prepared, std::ostream& out) {
  const ordered_json& pieces = json["list"];
  const std::string unit = prepared.volume.unit.empty() ? "" : " " + prepared.volume.unit;
  out << "pieces        " << pieces.size() << ", inside is " << json["inside"].get<std::string>()
      << " isovalue " << base::shortText(json["isovalue"].get<double>()) << unit << '\n';
  if (pieces.empty()) return;
  std::vector<std::vector<std::string>> table{
      {"id", "volume mm^3", "area mm^2", "voxels", "bounds mm", "seed mm"}};
  for (std::size_t i = 0; i < std::min(pieces.size(), kTableRows); ++i) table.push_back(rowOf(pieces[i]));
  printTable(out, table);
  if (pieces.size() > kTableRows) out << "  ... --json lists all\n";
}

}  // namespace isolux::app
