// What isolux measure says of how a surface is curved: as JSON, as text, as a table (.csv) and as a plot
// (.svg).
#pragma once

#include <filesystem>
#include <ostream>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "base/progress.h"
#include "volume/measure/curvature_distribution.h"

namespace isolux::app {

nlohmann::ordered_json curvatureJson(const volume::CurvatureDistribution& curvature);
void printCurvature(const nlohmann::ordered_json& curvature, std::ostream& out);

// A line for each bin of each measure: measure, unit, low, high, area_mm2, clear_area_mm2. What lies beyond
// the bins has an infinite end.
std::string curvatureTable(const volume::CurvatureDistribution& curvature);

// Throws Error{input} where there is no gnuplot to make `picture` with.
void requireGnuplot(const std::filesystem::path& picture);
// `title`: what was measured. Throws Error{input} where there is no gnuplot or it fails.
void plotCurvature(const volume::CurvatureDistribution& curvature, const std::string& title,
                   const std::filesystem::path& picture, base::Progress& progress);

}  // namespace isolux::app
