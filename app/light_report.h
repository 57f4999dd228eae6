// What was baked and what it cost, for --stats and --explain.
#pragma once

#include <nlohmann/json.hpp>

#include "app/light_controller.h"

namespace isolux::app {

// The key "bake": mode, reason, texels, samples, rays, seconds, threads.
nlohmann::ordered_json bakeJson(const LightState& state);
void printBake(const LightState& state);  // one line on stdout

}  // namespace isolux::app
