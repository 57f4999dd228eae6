// What was baked and what it cost, for --stats and --explain.
#pragma once

#include <nlohmann/json.hpp>

#include "app/light/light_controller.h"

namespace isolux::app {

// The key "bake": mode, reason, texels, samples, rays, seconds, threads, notes (lines).
nlohmann::ordered_json bakeJson(const LightState& state);
void printBake(const LightState& state);  // on stdout: one line, and one for each note

}  // namespace isolux::app
