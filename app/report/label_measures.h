// Measures of the labels of a label map, as JSON, as a table and as CSV.
#pragma once

#include <ostream>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "base/progress.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

// Measures every label but 0. Returns the keys of `measure --labels --json` (docs/reference/outputs.md).
// `smoothing`: of each label's surface, voxels. `anyway`: also if lengths are doubtful. Throws Error: input
// with `file` where values are no labels or lengths are doubtful; interrupted, memory.
nlohmann::ordered_json labelMeasuresJson(const volume::PreparedVolume& prepared, const std::string& file,
                                         double smoothing, bool anyway, base::Progress& progress);

// A line for each label.
void printLabelMeasures(const nlohmann::ordered_json& json, std::ostream& out);
std::string labelMeasuresCsv(const nlohmann::ordered_json& json);

}  // namespace isolux::app
