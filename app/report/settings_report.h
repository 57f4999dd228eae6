// Lists all settings, of the scene and then of the machine, as text, JSON and a page.
#pragma once

#include <iosfwd>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace isolux::app {

// Print and return those whose path or meaning contains the word.
void printSettings(std::ostream& out, const std::string& word);
nlohmann::ordered_json settingsJson(const std::string& word);
// Prints docs/reference/settings.md.
void printSettingsPage(std::ostream& out);

}  // namespace isolux::app
