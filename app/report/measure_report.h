// Measures as JSON and as text.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <nlohmann/json_fwd.hpp>

#include "volume/measure/surface_measure.h"

namespace isolux::app {

nlohmann::ordered_json vectorOf(glm::dvec3 v);
nlohmann::ordered_json vectorsOf(const std::vector<glm::dvec3>& vectors);
// {"value", "error"}, and what the error is made of: {"quadrature", "sampling", "noise", "cut"}.
nlohmann::ordered_json measuredJson(const volume::Measured& measured);
nlohmann::ordered_json measuredJson(const volume::Measured& measured, const volume::ErrorParts& parts);

// Returns the measures of a whole surface: the keys from "area_mm2" to "open_reason" of
// docs/reference/outputs.md.
nlohmann::ordered_json surfaceJson(const volume::SurfaceMeasure& surface);
// Why it is open, as one clause.
std::string openReason(const volume::SurfaceMeasure& surface);

// What `isolux measure --json` prints, as lines.
void printMeasures(const nlohmann::ordered_json& json, std::ostream& out);

}  // namespace isolux::app
