// Measures as JSON and as text.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <ostream>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/measure/piece_measure.h"
#include "volume/measure/surface_measure.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

// {"value", "error"}, and what the error is made of: {"quadrature", "sampling", "noise", "cut"}.
nlohmann::ordered_json measuredJson(const volume::Measured& measured);
nlohmann::ordered_json measuredJson(const volume::Measured& measured, const volume::ErrorParts& parts);

struct SizedSurface {
  volume::SurfaceMeasure whole;
  std::map<std::size_t, volume::PieceMeasure> pieces;  // those that are shown, by id; none within a box
};
// Measures what the scene's choice of components shows of the surface. `question.keeps` is set here. Throws
// Error{interrupted}.
SizedSurface sizedSurface(const volume::PreparedVolume& prepared, const scene::Scene& scene,
                          volume::SurfaceQuestion question, base::Progress& progress);
// Returns the keys from "isovalue" to "pieces" of docs/reference/outputs.md. doubt: why lengths are doubtful.
nlohmann::ordered_json surfaceJson(const volume::PreparedVolume& prepared,
                                   const volume::SurfaceQuestion& question, const SizedSurface& sized,
                                   const std::optional<std::string>& doubt);
// Why the surface is open, as one clause.
std::string openReason(const volume::SurfaceMeasure& surface);

// Prints what `isolux measure --json` writes, as lines.
void printMeasures(const nlohmann::ordered_json& json, std::ostream& out);

}  // namespace isolux::app
