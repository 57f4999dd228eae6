// The connected pieces of an isosurface's inside, as JSON and as a table.
#pragma once

#include <cstddef>
#include <ostream>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/measure/piece_measure.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

// "12.3 +- 0.4" of {"value", "error"}; "1,2,3 to 4,5,6" of two corners.
std::string withErrorText(const nlohmann::ordered_json& measured);
std::string boundsText(const nlohmann::ordered_json& bounds);

// {"id", "volume_mm3", "area_mm2", "bounds_mm", "open"}.
nlohmann::ordered_json pieceJson(std::size_t id, const volume::PieceMeasure& piece);

// {"isovalue", "inside", "count", "list"} of the isosurface of a resolved scene: all pieces, each with its
// voxels, its seed and whether the scene's choice shows it. Throws Error: interrupted, memory.
nlohmann::ordered_json piecesJson(const volume::PreparedVolume& prepared, const scene::Scene& scene,
                                  base::Progress& progress);

// A line for each of the largest.
void printPieceTable(const nlohmann::ordered_json& pieces, const volume::PreparedVolume& prepared,
                     std::ostream& out);

}  // namespace isolux::app
