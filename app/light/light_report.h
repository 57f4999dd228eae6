// What was baked and what it cost, and the exposure that was taken, for --stats and --explain.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/light/light_controller.h"

namespace isolux::app {

// The key "bake": mode, reason, texels, samples, rays, seconds, threads, notes (lines).
nlohmann::ordered_json bakeJson(const LightState& state);
// Returns what --stats says of a bake.
nlohmann::ordered_json bakeStats(const LightState& state, const volume::Grid& grid);
void printBake(const LightState& state);  // on stdout: one line, and one for each note

// The key "exposure": stops, from ("setting", "surface", "lights"), and of a surface median and highlight;
// null where no light is shown. `light` may be null.
nlohmann::ordered_json exposureJson(const scene::Scene& resolved, const gi::PictureLight* light);
void printExposure(const scene::Scene& resolved, const gi::PictureLight* light);  // one line, or none

}  // namespace isolux::app
