// Measures as JSON and as text.
#pragma once

#include <ostream>
#include <vector>

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "volume/measure/measured.h"

namespace isolux::app {

nlohmann::ordered_json vectorOf(glm::dvec3 v);
nlohmann::ordered_json vectorsOf(const std::vector<glm::dvec3>& vectors);
// {"value", "error"}, and what the error is made of: {"quadrature", "sampling", "noise", "cut"}.
nlohmann::ordered_json measuredJson(const volume::Measured& measured);
nlohmann::ordered_json measuredJson(const volume::Measured& measured, const volume::ErrorParts& parts);

// What `isolux measure --json` prints, as lines.
void printMeasures(const nlohmann::ordered_json& json, std::ostream& out);

}  // namespace isolux::app
