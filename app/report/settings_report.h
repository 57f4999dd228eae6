// The list of settings for others than people.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace isolux::app {

// What `isolux settings WORD --json` prints: settings of the scene, then of the machine, whose path or
// meaning contains the word.
nlohmann::ordered_json settingsJson(const std::string& word);

}  // namespace isolux::app
